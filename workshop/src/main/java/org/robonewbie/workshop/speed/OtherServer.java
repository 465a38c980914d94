package org.robonewbie.workshop.speed;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.locks.LockSupport;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.protocol.tcp.MonitorLink;
import org.robonewbie.protocol.tcp.TcpAgentLink;

/**
 * Server in another process, such as rcssserver3d in sync mode. Robots are placed through its trainer port.
 *
 * <p>Such a server accepts connections only between two cycles. Robots therefore join one after the other while the earlier ones keep
 * replying. Admission failures and stalls are reported as exceptions.
 */
final class OtherServer implements BenchmarkServer {

    /** Number of messages after which a robot without a team counts as rejected. */
    private static final int MESSAGES_TO_JOIN = 50;

    /** Maximum number of cycles until the first message to a new robot. */
    private static final int CYCLES_TO_CREATE = 500;

    private static final long PAUSE_NANOSECONDS = 100_000;

    private final ServerAddress address;
    private final MonitorLink trainer;
    private final StallGuard guard;

    OtherServer(ServerAddress address, Duration patience) throws IOException {
        this.address = address;
        this.trainer = MonitorLink.connect(address.host(), address.monitorPort());
        this.guard = new StallGuard(patience);
    }

    @Override
    public List<BenchmarkAgent> gather(int robots) throws IOException {
        List<BenchmarkAgent> agents = new ArrayList<>();
        for (int robot = 0; robot < robots; robot++) {
            TcpAgentLink link = TcpAgentLink.connect(address.host(), address.agentPort());
            BenchmarkAgent agent = new BenchmarkAgent(new WatchedLink(link, guard), robot);
            agent.create();
            agents.add(agent);
            admit(agent, agents);
        }
        return agents;
    }

    /** Replies to all messages until the last robot has joined its team. */
    private void admit(BenchmarkAgent last, List<BenchmarkAgent> all) throws IOException {
        int cycles = 0;
        while (!last.isInTeam()) {
            if (last.messages() > MESSAGES_TO_JOIN || cycles > CYCLES_TO_CREATE) {
                throw new IOException("Robot " + all.size() + " of the benchmark could not join: "
                        + (last.messages() == 0 ? "it received no message" : "it was not assigned to a team")
                        + ". Check that the server has a free place and that no other robots are in its team.");
            }
            if (!answer(all)) {
                LockSupport.parkNanos(PAUSE_NANOSECONDS);
            } else {
                cycles++;
            }
        }
    }

    /** {@return whether a reply was sent to any message} */
    private static boolean answer(List<BenchmarkAgent> agents) throws IOException {
        boolean answered = false;
        for (BenchmarkAgent agent : agents) {
            if (agent.isMessageWaiting()) {
                agent.join();
                answered = true;
            }
        }
        return answered;
    }

    @Override
    public void cycle() {
        // The server starts its next cycle when all agents have replied.
    }

    @Override
    public void place(int robot, Vector3 position) throws IOException {
        TeamSide side = robot % 2 == 0 ? TeamSide.LEFT : TeamSide.RIGHT;
        PlayerNumber player = new PlayerNumber(side, BenchmarkAgent.number(robot));
        trainer.send(new Order.MoveAndTurnRobot(player, position, 70.0 * robot));
    }

    @Override
    public void playOn() throws IOException {
        trainer.send(new Order.ChangePlayMode(PlayMode.PLAY_ON));
    }

    @Override
    public OptionalLong cpuNanoseconds() {
        if (address.processId().isEmpty()) {
            return OptionalLong.empty();
        }
        Optional<Duration> time = ProcessHandle.of(address.processId().getAsLong())
                .flatMap(process -> process.info().totalCpuDuration());
        return time.map(duration -> OptionalLong.of(duration.toNanos())).orElse(OptionalLong.empty());
    }

    @Override
    public OptionalLong allocatedBytes() {
        return OptionalLong.empty();
    }

    @Override
    public void close() {
        guard.close();
        trainer.close();
    }
}

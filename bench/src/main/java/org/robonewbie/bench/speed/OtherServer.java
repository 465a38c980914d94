package org.robonewbie.bench.speed;

import java.io.IOException;
import java.time.Duration;
import java.util.Optional;
import java.util.OptionalLong;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.protocol.tcp.MonitorLink;
import org.robonewbie.protocol.tcp.TcpAgentLink;

/** A server of another process, such as rcssserver3d, that waits for its agents; robots are placed by its trainer port. */
final class OtherServer implements BenchmarkServer {

    private final ServerAddress address;
    private final MonitorLink trainer;

    OtherServer(ServerAddress address) throws IOException {
        this.address = address;
        this.trainer = MonitorLink.connect(address.host(), address.monitorPort());
    }

    @Override
    public AgentLink connect() throws IOException {
        return TcpAgentLink.connect(address.host(), address.agentPort());
    }

    @Override
    public void cycle() {
        // The server continues by itself when all have answered.
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
        trainer.close();
    }
}

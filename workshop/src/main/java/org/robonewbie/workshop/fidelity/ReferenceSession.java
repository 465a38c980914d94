package org.robonewbie.workshop.fidelity;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.effector.EffectorCommand.CreateRobot;
import org.robonewbie.protocol.effector.EffectorMessageWriter;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.protocol.perceptor.GameState;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PerceptorMessageReader;
import org.robonewbie.protocol.tcp.TcpAgentLink;
import org.robonewbie.simulator.physics.BodyPose;

/**
 * Session with one robot on a server in sync mode, which is also observed through the monitor port.
 *
 * <p>The server reads the reply to message N after step N + 1, so the reply takes effect in step N + 2. It is stored in line N + 1 of the
 * recording. While the server is waiting for the reply to message N, its latest monitor message is that of step N + 1; this relates the two
 * message streams.
 */
final class ReferenceSession implements AutoCloseable {

    private static final int CYCLES_TO_STAND_STILL = 150;
    private static final int CYCLES_TO_JOIN = 60;
    private static final double BEAM_METRES = 5;
    private static final double EXACT_METRES = 1e-3;
    private static final int CYCLES_TO_APPEAR = 5;
    /** Error message for a server that skips monitor messages. */
    static final String STEP_ADVICE = "The server does not send a monitor message in each cycle."
            + " Set $monitorStep = 0.02 in spark.rb, or start robonewbie simulator with --monitor-step 0.02.";

    /**
     * Result of a recording.
     *
     * @param lines one line per cycle, without the header
     * @param way start sequence of the robot; empty if balls were recorded
     * @param isNoisy whether the server did not beam the robot exactly to its target
     */
    record Take(List<String> lines, Optional<JoiningWay> way, boolean isNoisy) {}

    private record Exchange(PerceptorMessage message, String sent) {}

    private final AgentLink agent;
    private final MonitorFeed monitor;
    private final MessageBuffer buffer = new MessageBuffer();
    private final PerceptorMessageReader reader = new PerceptorMessageReader();
    private int messagesBeforeInit;
    private int cycles;

    private ReferenceSession(AgentLink agent, MonitorFeed monitor) {
        this.agent = agent;
        this.monitor = monitor;
    }

    static ReferenceSession open(ReferenceServer server) throws IOException {
        MonitorFeed monitor = MonitorFeed.connect(server.host(), server.monitorPort());
        try {
            return new ReferenceSession(TcpAgentLink.connect(server.host(), server.port()), monitor);
        } catch (IOException e) {
            monitor.close();
            throw e;
        }
    }

    /**
     * Records a robot that starts standing. Returns an empty result if monitor messages were delayed and therefore
     * cannot be assigned to cycles.
     *
     * @param type the robot type, 0 to 4
     * @param commands command text for each cycle
     */
    Optional<Take> record(int type, List<String> commands) throws IOException {
        Vector3 place = takePlace(type);
        int cyclesToBeam = cycles;
        standStill();
        List<Exchange> rows = new ArrayList<>();
        monitor.requestFullState();
        monitor.awaitQuiet();
        int newest = monitor.awaitRepetition();
        JoiningWay way = new JoiningWay(messagesBeforeInit + 2, place, cyclesToBeam, cycles - cyclesToBeam);
        for (String command : commands) {
            monitor.requestFullState();
            rows.add(new Exchange(exchange(command), command));
            if (!monitor.await(newest + rows.size())) {
                throw new IOException(STEP_ADVICE);
            }
        }
        boolean isDelayed = monitor.hasMoreThan(newest + rows.size());
        checkTime(rows);
        return isDelayed
                ? Optional.empty()
                : Optional.of(new Take(
                        lines(rows, newest - 1), Optional.of(way), isBeamedElsewhere(newest - 1, rows.size())));
    }

    /** Records balls in order while a robot stands idle. */
    Take recordBalls(List<BallCase> cases) throws IOException {
        takePlace(0);
        standStill();
        BallSession balls = new BallSession(this, monitor);
        List<String> lines = new ArrayList<>();
        for (BallCase ballCase : cases) {
            lines.addAll(balls.record(ballCase));
        }
        return new Take(lines, Optional.empty(), false);
    }

    @Override
    public void close() {
        agent.close();
        monitor.close();
    }

    /**
     * Creates a robot, joins a team, and returns the robot's position. A server does not wait for a new agent during
     * the agent's first cycles.
     */
    private Vector3 takePlace(int type) throws IOException {
        send(
                type == 0
                        ? "(scene " + CreateRobot.SCENE + ")"
                        : "(scene " + CreateRobot.SCENE_OF_TYPE + " " + type + ")");
        receive();
        messagesBeforeInit = 1;
        monitor.awaitQuiet();
        while (agent.isMessageWaiting()) {
            receive();
            messagesBeforeInit++;
        }
        monitor.watch(join());
        Vector3 torso = whereItIs();
        return new Vector3(millimetres(torso.x()), millimetres(torso.y()), torso.z());
    }

    private Vector3 whereItIs() throws IOException {
        for (int i = 0; i < CYCLES_TO_APPEAR; i++) {
            monitor.requestFullState();
            exchange("");
            monitor.awaitQuiet();
            Optional<BodyPose> torso = monitor.lastTorso();
            if (torso.isPresent()) {
                return torso.get().position();
            }
        }
        throw new IOException(STEP_ADVICE);
    }

    private boolean isBeamedElsewhere(int firstRow, int rows) {
        for (int i = firstRow; i < firstRow + rows; i++) {
            Optional<BodyPose> torso = monitor.torso(i);
            if (torso.isPresent()) {
                Vector3 place = torso.get().position();
                return Math.abs(Math.abs(place.x()) - BEAM_METRES) > EXACT_METRES || Math.abs(place.y()) > EXACT_METRES;
            }
        }
        return false;
    }

    private static double millimetres(double metres) {
        return Math.rint(metres * 1e3) / 1e3;
    }

    private void standStill() throws IOException {
        exchange("(beam -" + BEAM_METRES + " 0 0)");
        for (int i = 0; i < CYCLES_TO_STAND_STILL; i++) {
            exchange("");
        }
        monitor.awaitQuiet();
        if (agent.isMessageWaiting()) {
            throw new IOException(MonitorFeed.DOES_NOT_WAIT);
        }
    }

    private PlayerNumber join() throws IOException {
        cycles = 0;
        PerceptorMessage answer = exchange("(init (unum 0)(teamname Reference))");
        for (int i = 0; i < CYCLES_TO_JOIN; i++) {
            Optional<PlayerNumber> player = answer.gameState().flatMap(ReferenceSession::player);
            if (player.isPresent()) {
                return player.get();
            }
            answer = exchange("");
        }
        throw new IOException(
                "The robot could not join a team. Check that the server does not already have" + " two teams.");
    }

    private static Optional<PlayerNumber> player(GameState state) {
        return state.side().isPresent() && state.number().isPresent()
                ? Optional.of(new PlayerNumber(
                        state.side().orElse(TeamSide.LEFT), state.number().getAsInt()))
                : Optional.empty();
    }

    private static void checkTime(List<Exchange> rows) throws IOException {
        double seconds = rows.get(rows.size() - 1).message().seconds().orElse(0)
                - rows.get(0).message().seconds().orElse(0);
        if (Math.abs(seconds - Cycle.SECONDS * (rows.size() - 1)) > Cycle.SECONDS / 2) {
            throw new IOException(MonitorFeed.DOES_NOT_WAIT);
        }
    }

    private List<String> lines(List<Exchange> rows, int firstTorso) {
        List<String> lines = new ArrayList<>();
        for (int i = 0; i < rows.size(); i++) {
            lines.add(RowWriter.row(
                    rows.get(i).message(),
                    monitor.torso(firstTorso + i),
                    rows.get(i).sent()));
        }
        return lines;
    }

    PerceptorMessage exchange(String commands) throws IOException {
        send(commands);
        cycles++;
        return receive();
    }

    private void send(String commands) throws IOException {
        buffer.clear();
        buffer.append(commands + EffectorMessageWriter.SYNCHRONISE);
        agent.send(buffer);
    }

    private PerceptorMessage receive() throws IOException {
        if (!agent.receive(buffer)) {
            throw new IOException("The server closed the agent's connection.");
        }
        return reader.read(buffer);
    }
}

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
 * One robot on a server in sync mode, watched through the monitor port at the same time.
 *
 * <p>The answer to message N is read when the world has already made step N + 1, so that it acts in step N + 2, and what was
 * sent stands on line N + 1 of the recording. While the server waits for the answer to message N, its newest message to
 * monitors is the one of step N + 1; that tells which belong together.
 */
final class ReferenceSession implements AutoCloseable {

    private static final int CYCLES_TO_STAND_STILL = 150;
    private static final int CYCLES_TO_JOIN = 60;
    private static final double BEAM_METRES = 5;
    private static final double EXACT_METRES = 1e-3;
    private static final int CYCLES_TO_BE_SEEN = 5;
    /** Said of a server that leaves out cycles. */
    static final String STEP_ADVICE = "The server does not send a message to monitors in each cycle."
            + " Set $monitorStep = 0.02 in spark.rb, or start robonewbie simulator with --monitor-step 0.02.";

    /**
     * What was recorded.
     *
     * @param lines one for each cycle, without header
     * @param way how the robot came to where it stood; empty if the ball was recorded
     * @param isNoisy whether the robot was beamed elsewhere than it wished
     */
    record Take(List<String> lines, Optional<JoiningWay> way, boolean isNoisy) {}

    private record Felt(PerceptorMessage message, String sent) {}

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
     * Records the robot from standing; empty when messages to monitors were delayed, so that it is unknown which belong to
     * which cycle.
     *
     * @param type the robot type, 0 to 4
     * @param commands what to send in each cycle
     */
    Optional<Take> record(int type, List<String> commands) throws IOException {
        Vector3 place = takePlace(type);
        int cyclesToBeam = cycles;
        standStill();
        List<Felt> rows = new ArrayList<>();
        monitor.requestFullState();
        monitor.awaitQuiet();
        int newest = monitor.awaitRepetition();
        JoiningWay way = new JoiningWay(messagesBeforeInit + 2, place, cyclesToBeam, cycles - cyclesToBeam);
        for (String command : commands) {
            monitor.requestFullState();
            rows.add(new Felt(exchange(command), command));
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

    /**
     * Records balls while a robot stands idle; empty when messages to monitors were delayed.
     *
     * @param cases how they are set in motion, in order
     */
    Optional<Take> recordBalls(List<BallCase> cases) throws IOException {
        takePlace(0);
        standStill();
        BallSession balls = new BallSession(this, monitor);
        List<String> lines = new ArrayList<>();
        for (BallCase ballCase : cases) {
            Optional<List<String>> recorded = balls.record(ballCase);
            if (recorded.isEmpty()) {
                return Optional.empty();
            }
            lines.addAll(recorded.get());
        }
        return Optional.of(new Take(lines, Optional.empty(), false));
    }

    @Override
    public void close() {
        agent.close();
        monitor.close();
    }

    /**
     * Creates a robot, joins, and returns where it was placed. A server runs its first cycles with a new agent without waiting
     * for it.
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
        for (int i = 0; i < CYCLES_TO_BE_SEEN; i++) {
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
        throw new IOException("The server does not let the robot join a team. Are there two teams already?");
    }

    private static Optional<PlayerNumber> player(GameState state) {
        return state.side().isPresent() && state.number().isPresent()
                ? Optional.of(new PlayerNumber(
                        state.side().orElse(TeamSide.LEFT), state.number().getAsInt()))
                : Optional.empty();
    }

    private static void checkTime(List<Felt> rows) throws IOException {
        double seconds = rows.get(rows.size() - 1).message().seconds().orElse(0)
                - rows.get(0).message().seconds().orElse(0);
        if (Math.abs(seconds - Cycle.SECONDS * (rows.size() - 1)) > Cycle.SECONDS / 2) {
            throw new IOException(MonitorFeed.DOES_NOT_WAIT);
        }
    }

    private List<String> lines(List<Felt> rows, int firstTorso) {
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
            throw new IOException("The server has closed the agent's connection.");
        }
        return reader.read(buffer);
    }
}

package org.robonewbie.learning.trial;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.AgentDriver;
import org.robonewbie.agent.Options;
import org.robonewbie.learning.objective.TrueState;
import org.robonewbie.learning.objective.TrueStateEye;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.effector.EffectorMessageWriter;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PerceptorMessageReader;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.cycle.SteppedSimulator;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.world.Robot;

/**
 * A student's program alone on the beginners' pitch, with noise and delay as in a game, while the true state is observed. The
 * same seed and the same program give the same trial. The program's {@code main} and {@code defaults} have no effect.
 *
 * <pre>{@code
 * try (AgentTrial trial = new AgentTrial(new MyAgent(), seed)) {
 *     trial.begin(new Vector3(-1, 0, 0), 0, Vector3.ZERO);
 *     TrueState last = trial.look();
 *     while (last.seconds() < 10 && !last.isFallen()) {
 *         last = trial.step();
 *     }
 * }
 * }</pre>
 */
public final class AgentTrial implements AutoCloseable {

    private static final double TORSO_METRES = 0.39;
    private static final int CYCLES_TO_APPEAR = 3;
    private static final int CYCLES_TO_SETTLE = 25;

    private final AgentDriver agent;
    private final SteppedSimulator simulator;
    private final AgentLink link;
    private final PerceptorMessageReader reader = new PerceptorMessageReader();
    private final MessageBuffer received = new MessageBuffer();
    private final MessageBuffer answer = new MessageBuffer();
    private final EffectorMessageWriter writer = new EffectorMessageWriter(answer);
    private final TrueStateEye eye;
    private PerceptorMessage message;

    /**
     * Starts a simulator and lets the program's robot in.
     *
     * @param agent the program
     * @param seed start of all noise
     */
    public AgentTrial(Agent agent, long seed) {
        this.agent = new AgentDriver(agent);
        simulator = SteppedSimulator.start(WorldSettings.beginner().withSeed(seed), Console.silent());
        link = simulator.connect();
        try {
            message = join();
        } catch (IOException impossible) {
            throw new UncheckedIOException("The simulator of the trial does not answer.", impossible);
        }
        this.agent.introduce(Options.none().withTeam("Trial").withNumber(1), TeamSide.LEFT);
        simulator.match().setPlayMode(PlayMode.PLAY_ON);
        eye = new TrueStateEye(simulator.world(), robot());
    }

    /**
     * Moves robot and ball to their places; the robot stands with all joints at 0.
     *
     * @param place where the robot stands; its height does not matter
     * @param degrees its heading; 0 is towards the opponents' goal, positive is left
     * @param ball where the ball lies; its height does not matter
     */
    public void begin(Vector3 place, double degrees, Vector3 ball) {
        robot().moveUpright(new Vector3(place.x(), place.y(), TORSO_METRES), degrees - 90);
        robot().wake();
        double radius = simulator.world().ball().properties().radius();
        simulator.world().ball().place(new Vector3(ball.x(), ball.y(), radius));
        for (int i = 0; i < CYCLES_TO_SETTLE; i++) {
            exchange(List.of());
        }
    }

    /**
     * Looks at the truth.
     *
     * @return what is true now
     */
    public TrueState look() {
        return eye.look();
    }

    /**
     * Runs the program and the world for one cycle.
     *
     * @return the true state afterwards
     */
    public TrueState step() {
        exchange(agent.respond(message));
        return eye.look();
    }

    @Override
    public void close() {
        link.close();
        simulator.close();
    }

    private PerceptorMessage join() throws IOException {
        writer.createRobot("rsg/agent/nao/nao.rsg", List.of());
        send();
        for (int i = 1; i < CYCLES_TO_APPEAR; i++) {
            simulator.cycle();
        }
        receive();
        writer.joinTeam(1, "Trial");
        send();
        return receive();
    }

    private void exchange(List<EffectorCommand> commands) {
        try {
            for (EffectorCommand command : commands) {
                if (!(command instanceof EffectorCommand.Synchronise) && !(command instanceof EffectorCommand.Beam)) {
                    writer.write(command);
                }
            }
            send();
            message = receive();
        } catch (IOException broken) {
            throw new UncheckedIOException("The simulator of the trial does not answer.", broken);
        }
    }

    /** Sends what is written and lets the simulator run a cycle. */
    private void send() throws IOException {
        writer.synchronise();
        link.send(answer);
        answer.clear();
        simulator.cycle();
    }

    private PerceptorMessage receive() throws IOException {
        if (!link.receive(received)) {
            throw new IllegalStateException("The simulator has sent the robot of the trial away.");
        }
        return reader.read(received);
    }

    private Robot robot() {
        return simulator.world().robots().get(0);
    }
}

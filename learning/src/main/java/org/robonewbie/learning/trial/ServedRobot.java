package org.robonewbie.learning.trial;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.function.BooleanSupplier;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.AgentDriver;
import org.robonewbie.agent.motion.Motions;
import org.robonewbie.agent.walk.Walk;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.effector.EffectorMessageWriter;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PerceptorMessageReader;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.cycle.SteppedSimulator;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.world.Ball;
import org.robonewbie.simulator.world.Robot;

/**
 * A robot on the pitch of a whole simulator, with all that lies between an agent and the physics: messages in both directions,
 * noise, rules and the delay. An {@link Agent} answers its messages; where it really is comes from the simulator.
 *
 * <pre>{@code
 * try (ServedRobot robot = new ServedRobot(seed)) {
 *     robot.perform("walk-forward");
 *     double metres = robot.forward();
 * }
 * }</pre>
 */
public final class ServedRobot implements AutoCloseable {

    private static final double START_X = -4.5;
    private static final double START_Y = 1.5;
    private static final int CYCLES_TO_SETTLE = 25;

    /** The first two cycles bring no message, since the robot appears in the first one. */
    private static final int CYCLES_TO_APPEAR = 3;

    private final SteppedSimulator simulator;
    private final AgentLink link;
    private final Puppet puppet = new Puppet();
    private final AgentDriver driver = new AgentDriver(puppet);
    private final PerceptorMessageReader reader = new PerceptorMessageReader();
    private final MessageBuffer received = new MessageBuffer();
    private final MessageBuffer answer = new MessageBuffer();
    private final EffectorMessageWriter writer = new EffectorMessageWriter(answer);
    private Vector3 start = Vector3.ZERO;
    private long cycles;
    private double lastDegrees;
    private double turnedDegrees;
    private boolean fallen;

    /**
     * Starts a simulator and puts a robot into it that goes to the stance.
     *
     * @param seed start of all noise
     */
    public ServedRobot(long seed) {
        this(seed, RobotType.TYPE_0);
    }

    /**
     * Starts a simulator and puts a robot of some type into it that goes to the stance.
     *
     * @param seed start of all noise
     * @param type how the robot is built
     */
    public ServedRobot(long seed, RobotType type) {
        simulator = SteppedSimulator.start(WorldSettings.beginner().withSeed(seed), Console.silent());
        link = simulator.connect();
        join(type);
        perform("stand");
        hold(0.3);
        start = robot().torso().position();
        lastDegrees = headingDegrees();
        turnedDegrees = 0;
        cycles = 0;
        fallen = false;
    }

    /**
     * Plays a motion to its end, as an agent does.
     *
     * @param motion its name
     */
    public void perform(String motion) {
        puppet.motions().start(motion);
        goOn(() -> puppet.motions().isFinished(), 60);
    }

    /**
     * Walks with the walk engine until something is reached or the robot falls, and stops.
     *
     * @param forwardMetresPerSecond as for {@link Walk#towards}
     * @param leftMetresPerSecond as for {@link Walk#towards}
     * @param turnDegreesPerSecond as for {@link Walk#towards}
     * @param reached whether it is far enough
     * @return how many seconds it took without the stop
     */
    public double walk(
            double forwardMetresPerSecond,
            double leftMetresPerSecond,
            double turnDegreesPerSecond,
            BooleanSupplier reached) {
        double before = seconds();
        puppet.walk().towards(forwardMetresPerSecond, leftMetresPerSecond, turnDegreesPerSecond);
        goOn(() -> fallen || reached.getAsBoolean(), 60);
        double after = seconds();
        puppet.walk().stop();
        goOn(() -> !puppet.walk().isWalking(), 5);
        return after - before;
    }

    /**
     * Waits.
     *
     * @param seconds how long
     */
    public void hold(double seconds) {
        double end = seconds() + seconds - Cycle.SECONDS / 2;
        goOn(() -> seconds() > end, seconds + 1);
    }

    /** {@return whether the robot stands upright and at rest after a moment, and has never fallen} */
    public boolean endsStanding() {
        hold(0.8);
        return !fallen && uprightness() > 0.98 && robot().torsoVelocity().length() < 0.05;
    }

    /** Forgets that the robot has fallen. */
    public void forgetFall() {
        fallen = false;
    }

    /** {@return the uprightness of the torso: the cosine of its tilt} */
    public double uprightness() {
        return robot().torso().rotation().zz();
    }

    /** {@return the duration of the trial so far in simulated seconds} */
    public double seconds() {
        return cycles * Cycle.SECONDS;
    }

    /** {@return metres that the robot has moved along its first heading, which is that of the world's x axis} */
    public double forward() {
        return robot().torso().position().x() - start.x();
    }

    /** {@return degrees that the robot has turned, positive to the left, whole turns included} */
    public double turnedDegrees() {
        return turnedDegrees;
    }

    /** {@return the ball of this robot's pitch} */
    public Ball ball() {
        return simulator.world().ball();
    }

    /**
     * Returns a place as seen from where the robot first stands.
     *
     * @param ahead metres ahead of the torso
     * @param left metres to the left of it
     * @param height metres above the ground
     * @return the place in the world frame
     */
    public Vector3 place(double ahead, double left, double height) {
        return new Vector3(start.x() + ahead, start.y() + left, height);
    }

    @Override
    public void close() {
        link.close();
        simulator.close();
    }

    private void join(RobotType type) {
        writer.createRobot("rsg/agent/nao/nao_hetero.rsg", List.of(Integer.toString(type.ordinal())));
        send();
        for (int i = 1; i < CYCLES_TO_APPEAR; i++) {
            simulator.cycle();
        }
        receive();
        writer.joinTeam(1, "Trial");
        exchange();
        writer.beam(START_X, START_Y, 0);
        for (int i = 0; i < CYCLES_TO_SETTLE; i++) {
            exchange();
        }
        simulator.match().setPlayMode(PlayMode.PLAY_ON);
    }

    private void goOn(BooleanSupplier end, double mostSeconds) {
        double latest = seconds() + mostSeconds;
        while (!end.getAsBoolean() && seconds() < latest) {
            driver.respond(exchange()).forEach(this::write);
            watch();
        }
    }

    private PerceptorMessage exchange() {
        send();
        return receive();
    }

    /** Sends what is written and lets the simulator run a cycle. */
    private void send() {
        try {
            writer.synchronise();
            link.send(answer);
            answer.clear();
            simulator.cycle();
        } catch (IOException e) {
            throw new UncheckedIOException("The simulator of the trial does not answer.", e);
        }
    }

    private PerceptorMessage receive() {
        try {
            if (!link.receive(received)) {
                throw new IllegalStateException("The simulator has sent the robot of the trial away.");
            }
            cycles++;
            return reader.read(received);
        } catch (IOException e) {
            throw new UncheckedIOException("The simulator of the trial does not answer.", e);
        }
    }

    /** Each message is synchronised once, when it is sent. */
    private void write(EffectorCommand command) {
        if (!(command instanceof EffectorCommand.Synchronise)) {
            writer.write(command);
        }
    }

    private void watch() {
        double degrees = headingDegrees();
        turnedDegrees += Math.IEEEremainder(degrees - lastDegrees, 360);
        lastDegrees = degrees;
        fallen |= robot().isFallen();
    }

    private double headingDegrees() {
        return robot().headingDegrees();
    }

    private Robot robot() {
        return simulator.world().robots().get(0);
    }

    /** An agent that does what the trial says. */
    private static final class Puppet extends Agent {

        Motions motions() {
            return motions;
        }

        Walk walk() {
            return walk;
        }
    }
}

package org.robonewbie.agent;

import java.io.IOException;
import java.util.Optional;
import org.robonewbie.agent.cycle.RobotRuntime;
import org.robonewbie.agent.cycle.Session;
import org.robonewbie.agent.motion.LookAround;
import org.robonewbie.agent.motion.Motions;
import org.robonewbie.agent.perception.LocalFieldView;
import org.robonewbie.agent.running.CycleOwner;
import org.robonewbie.agent.running.JoinTurn;
import org.robonewbie.agent.running.LogPrinter;
import org.robonewbie.agent.running.RobotsOfProcess;
import org.robonewbie.agent.running.SimulatorConnection;
import org.robonewbie.agent.running.Watchdog;
import org.robonewbie.agent.walk.Walk;

/**
 * A NAO robot whose cycle is run by the program itself.
 *
 * <pre>{@code
 * try (Nao nao = Nao.connect(args)) {
 *     nao.perform("wave");
 *     while (nao.sense()) {
 *         nao.setJointSpeed(Joint.NECK_YAW, 20);
 *         nao.act();
 *     }
 * }
 * }</pre>
 *
 * <p>50 times per simulated second, {@link #sense} receives the readings of all sensors and {@link #act} sends the commands
 * that were set since then. Extend {@link Agent} to let the framework run the cycle.
 */
public final class Nao extends Robot implements AutoCloseable {

    private final SimulatorConnection simulator;
    private final Session session;
    private final Runnable onClose;

    Nao(RobotRuntime runtime, Session session, SimulatorConnection simulator, Runnable onClose) {
        super(runtime);
        this.session = session;
        this.simulator = simulator;
        this.onClose = onClose;
    }

    /**
     * Connects a robot to the simulator that the options select, starting one if necessary. Invalid options end the program
     * with exit code 2 and a one-sentence message.
     *
     * @param args the arguments of {@code main}, see {@link Options}
     * @return the robot at its starting pose
     */
    public static Nao connect(String... args) {
        try {
            Options options = Options.of(args);
            if (options.isHelp()) {
                System.out.println(Options.help());
                System.exit(0);
            }
            options.checkWords();
            return connect(options);
        } catch (StartUpException wrong) {
            System.err.println(wrong.getMessage());
            System.exit(2);
            throw wrong;
        }
    }

    /**
     * Connects a robot to the simulator that the options select, starting one if necessary.
     *
     * @param options options that include simulator, team, number and starting pose
     * @return the robot at its starting pose
     * @throws StartUpException if there is no such simulator or it refuses the robot
     */
    public static Nao connect(Options options) {
        return join(options, AgentRunner.open(options, 1, ""));
    }

    /** Joins the game in a simulator that serves only this robot. */
    static Nao join(Options options, SimulatorConnection simulator) {
        RobotRuntime runtime = new RobotRuntime("the robot");
        Watchdog watchdog = Watchdog.start(CycleOwner.PROGRAM, runtime.diagnostics(), Optional.empty(), slowness -> {});
        try {
            Session session =
                    AgentRunner.join(runtime, simulator, simulator.connect(), options, watchdog, new JoinTurn());
            LogPrinter printer = new LogPrinter(runtime.log(), System.out, simulator::close);
            RobotsOfProcess.enter(runtime.diagnostics());
            watchdog.thinkBegins();
            return new Nao(runtime, session, simulator, () -> {
                watchdog.close();
                printer.close();
                RobotsOfProcess.leave(runtime.diagnostics());
            });
        } catch (IOException lost) {
            watchdog.close();
            simulator.close();
            throw new StartUpException(AgentRunner.joinFailure(options, lost));
        } catch (StartUpException refused) {
            watchdog.close();
            simulator.close();
            throw refused;
        }
    }

    /**
     * Waits for the next message from the simulator and reads all sensors. If {@link #act} has not been called since
     * the last message, it is called first.
     *
     * @return false if the run is over
     */
    public boolean sense() {
        return session.senseNext();
    }

    /**
     * Sends the commands that were set since the last {@link #sense}. A second call in the same cycle is reported and has no
     * effect.
     */
    public void act() {
        session.actOnce();
    }

    /**
     * Performs a motion, sensing and acting in each cycle, and returns when it is over.
     *
     * @param motion name of the motion, see {@link Motions#start(String)}
     * @return whether the motion was played to its end; false if there is no such motion or the run is over
     */
    public boolean perform(String motion) {
        session.act();
        boolean performing = motions().start(motion);
        while (performing && !motions().isFinished()) {
            performing = session.senseNext();
            session.act();
        }
        return performing;
    }

    /** {@return the keyframe motions, which advance while the program runs its cycle} */
    public Motions motions() {
        return runtime().motions();
    }

    /** {@return the omnidirectional walk, which moves the robot while the program runs its cycle} */
    public Walk walk() {
        return runtime().walk();
    }

    /** {@return a head scan; the head moves only in cycles in which {@code lookAround().look()} is called} */
    public LookAround lookAround() {
        return runtime().lookAround();
    }

    /** {@return the robot's memory of the field, updated by each {@link #sense}} */
    public LocalFieldView fieldView() {
        return runtime().fieldView();
    }

    /** Leaves the game, prints the log and stops the simulator if this program started it. */
    @Override
    public void close() {
        session.close();
        simulator.close();
        onClose.run();
    }
}

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
 * A NAO robot in your hand: you turn the cycle yourself.
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
 * <p>50 times per simulated second {@link #sense} receives what all sensors say, and {@link #act} sends what was set since
 * then. {@link Agent} is for programs that let the framework turn the cycle.
 */
public final class Nao extends Robot implements AutoCloseable {

    private final SimulatorConnection simulator;
    private final Session session;
    private final Runnable farewell;

    /** Puts a robot into a session that has begun; its farewell follows when it has left. */
    Nao(RobotRuntime runtime, Session session, SimulatorConnection simulator, Runnable farewell) {
        super(runtime);
        this.session = session;
        this.simulator = simulator;
        this.farewell = farewell;
    }

    /**
     * Connects a robot to the simulator that the options name, or starts one. A mistake in the options ends the program with
     * one sentence and exit code 2.
     *
     * @param args the arguments of {@code main}, see {@link Options}
     * @return the robot on its first place
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
     * Connects a robot to the simulator that the options name, or starts one.
     *
     * @param options where the robot lives and who it is
     * @return the robot on its first place
     * @throws StartUpException if there is no such simulator or it refuses the robot
     */
    public static Nao connect(Options options) {
        return join(options, AgentRunner.open(options, 1, ""));
    }

    /** Brings a robot into the game of a simulator that belongs to this robot alone. */
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
            throw new StartUpException(AgentRunner.notLetIn(options, lost));
        } catch (StartUpException refused) {
            watchdog.close();
            simulator.close();
            throw refused;
        }
    }

    /**
     * Waits for the next message of the simulator and reads all sensors. If {@link #act} was forgotten, it acts first.
     *
     * @return false if the run is over
     */
    public boolean sense() {
        return session.senseNext();
    }

    /** Sends what was set since the last {@link #sense}; a second time in the same cycle it does nothing but report that. */
    public void act() {
        session.actOnce();
    }

    /**
     * Performs a motion and returns when it is over. It senses and acts by itself meanwhile.
     *
     * @param motion the name of the motion, see {@link Motions#start(String)}
     * @return whether it was played to its end; false if there is no such motion or the run is over
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

    /** {@return the motions, which play while the program goes on with its cycle} */
    public Motions motions() {
        return runtime().motions();
    }

    /** {@return the walk into any direction, while the program goes on with its cycle} */
    public Walk walk() {
        return runtime().walk();
    }

    /** {@return the head's movement to see more; moves only in cycles in which {@code lookAround().look()} is called} */
    public LookAround lookAround() {
        return runtime().lookAround();
    }

    /** {@return what the robot remembers of the field, renewed by each {@link #sense}} */
    public LocalFieldView fieldView() {
        return runtime().fieldView();
    }

    /** Leaves the game, prints the log and ends the simulator if it belongs to this program. */
    @Override
    public void close() {
        session.close();
        simulator.close();
        farewell.run();
    }
}

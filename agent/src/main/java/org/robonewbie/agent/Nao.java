package org.robonewbie.agent;

import java.io.IOException;
import java.util.OptionalDouble;
import org.robonewbie.agent.log.Logger;
import org.robonewbie.agent.log.Mistakes;
import org.robonewbie.agent.motion.MotionLibrary;
import org.robonewbie.agent.motion.Motions;
import org.robonewbie.agent.perception.LocalFieldView;
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
public final class Nao extends NaoBody implements AutoCloseable {

    private final Motions motions;
    private final Walk walk;
    private final LocalFieldView fieldView;
    private final Home home;
    private final Session session;
    private final LastWords lastWords;

    private Nao(Options options, Home home) throws IOException {
        super(new Logger("the robot"), new Mistakes(System.err));
        this.home = home;
        motions = new Motions(motors(), new MotionLibrary(), mistakes(), this::getBodyPosition);
        walk = new Walk(motors(), motions, mistakes(), this::getBodyPosition);
        fieldView = new LocalFieldView(mistakes());
        LinkPort port = new LinkPort(home.connect(), senses().buffer());
        thoughts().tellTo(home.telemetry());
        new StartDialogue(port, this, options).run();
        OptionalDouble life = home.endsByItself() ? OptionalDouble.empty() : options.seconds();
        session = new Session(this, walk, fieldView, port, life, System.err);
        lastWords = new LastWords(log(), home, System.out);
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
        Home home = Home.find(options, 1);
        System.out.println(home.description());
        try {
            return new Nao(options, home);
        } catch (IOException lost) {
            home.close();
            throw new StartUpException("The simulator has not let the robot in: " + lost.getMessage());
        } catch (StartUpException refused) {
            home.close();
            throw refused;
        }
    }

    /**
     * Brings a robot into the game that tells nobody about it.
     *
     * @throws IOException if the simulator closes the connection
     * @throws StartUpException if it refuses the robot
     */
    static Nao quiet(Options options, Home home) throws IOException {
        return new Nao(options, home);
    }

    /**
     * Waits for the next message of the simulator and reads all sensors. If {@link #act} was forgotten, it acts first.
     *
     * @return false if the run is over
     */
    public boolean sense() {
        return session.sense();
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
        boolean performing = motions.start(motion);
        while (performing && !motions.isFinished()) {
            performing = session.sense();
            session.act();
        }
        return performing;
    }

    /**
     * Gives access to motions that play while the program goes on with its cycle.
     *
     * @return the motions
     */
    public Motions motions() {
        return motions;
    }

    /**
     * Gives access to a walk into any direction, while the program goes on with its cycle.
     *
     * @return the walk
     */
    public Walk walk() {
        return walk;
    }

    /**
     * Gives access to what the robot remembers of the field.
     *
     * @return the view, renewed by each {@link #sense}
     */
    public LocalFieldView fieldView() {
        return fieldView;
    }

    /** Leaves the game, prints the log and ends the simulator if it is the robot's own. */
    @Override
    public void close() {
        session.close();
        home.close();
        lastWords.close();
    }
}

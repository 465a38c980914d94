package org.robonewbie.trial;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.cycle.SteppedSimulator;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.recording.RecordingTarget;
import org.robonewbie.simulator.soccer.MatchState;
import org.robonewbie.simulator.world.Ball;
import org.robonewbie.simulator.world.Robot;

/**
 * A deterministic simulation of a {@link Scene}, with a {@link Controller} for each of its robots. Trials with the same scene,
 * controllers and seed are bit-identical, because the simulation waits for every controller.
 *
 * <pre>{@code
 * try (Trial trial = Trial.direct(Scene.of(RobotStart.at(-3, 0)), 1, Controller.ofMotion(kick))) {
 *     Measure kick = new KickDistance();
 *     trial.run(10, kick);
 *     double metres = kick.value();
 * }
 * }</pre>
 *
 * <p>In a <em>served</em> trial, robots exchange messages with a complete simulator including the referee. In a <em>direct</em>
 * trial, they join in the same way, but then only the physics runs. This is faster, but there is no referee, and robots do not
 * hear messages. Without noise, a robot behaves identically in both kinds of trial. Not thread-safe.
 */
public final class Trial implements AutoCloseable {

    private static final double TORSO_METRES = 0.39;
    private static final int CYCLES_TO_SETTLE = 25;
    private static final int CYCLES_TO_WAKE = 14;
    private static final int CYCLES_TO_REST = 5;

    /** A robot appears in the first cycle and gets its first message after the third. */
    private static final int CYCLES_TO_APPEAR = 3;

    /**
     * Number of messages that contain the robot's number. Together with {@link #CYCLES_TO_WAKE}, they make up the 17 messages
     * that a program needs to start.
     */
    private static final int CYCLES_TO_JOIN = 3;

    private final Scene scene;
    private final SteppedSimulator simulator;
    private final TrialListener listener;
    private final List<TrialBody> bodies = new ArrayList<>();
    private World world;
    private List<SensorReadings> firstReadings = List.of();
    private TrialHook hook = trial -> {};
    private long cycles;

    private Trial(Scene scene, long seed, TrialListener listener, RecordingTarget recording) {
        this.scene = scene;
        this.listener = listener;
        WorldSettings settings = WorldSettings.beginner()
                .withParameters(scene.parameters())
                .withNoise(scene.noise())
                .withLandscape(scene.landscape())
                .withSeed(seed);
        simulator = SteppedSimulator.start(settings, recording, Console.silent());
        world = new ServedWorld(simulator);
    }

    /**
     * Starts a trial with a complete simulator.
     *
     * @param scene the initial state of the trial
     * @param seed seed for all noise
     * @param controllers the controller of each robot of the scene
     * @return the trial, which has not advanced yet
     */
    public static Trial served(Scene scene, long seed, Controller... controllers) {
        Iterator<Controller> all = each(scene, controllers);
        return observed(scene, seed, TrialListener.NONE, RecordingTarget.NONE, start -> all.next());
    }

    /**
     * Starts a trial with a complete simulator, a listener and a recording.
     *
     * @param scene the initial state of the trial
     * @param seed seed for all noise
     * @param listener called after each cycle
     * @param recording receives a recording of the trial
     * @param cast creates the controller of a robot when the robot enters the pitch
     * @return the trial, which has not advanced yet
     */
    public static Trial observed(
            Scene scene,
            long seed,
            TrialListener listener,
            RecordingTarget recording,
            Function<RobotStart, ? extends Controller> cast) {
        Trial trial = new Trial(scene, seed, listener, recording);
        trial.begin(cast, trial.world);
        return trial;
    }

    /**
     * Starts a trial with physics only.
     *
     * @param scene the initial state of the trial
     * @param seed seed for all noise
     * @param controllers the controller of each robot of the scene
     * @return the trial, which has not advanced yet
     */
    public static Trial direct(Scene scene, long seed, Controller... controllers) {
        Iterator<Controller> all = each(scene, controllers);
        Trial trial = new Trial(scene, seed, TrialListener.NONE, RecordingTarget.NONE);
        trial.begin(start -> all.next(), new DirectWorld(trial.simulator, scene.noise(), seed));
        return trial;
    }

    private static Iterator<Controller> each(Scene scene, Controller... controllers) {
        if (controllers.length != scene.robots().size()) {
            throw new IllegalArgumentException(controllers.length + " controllers for "
                    + scene.robots().size() + " robots. Pass one controller for each robot of the scene.");
        }
        return List.of(controllers).iterator();
    }

    private void begin(Function<RobotStart, ? extends Controller> cast, World played) {
        try {
            for (RobotStart start : scene.robots()) {
                enter(start, cast.apply(start));
            }
            scene.ball().ifPresent(this::placeBall);
            world = played;
            bodies.forEach(this::playPrelude);
            keep();
        } catch (RuntimeException | Error failure) {
            close();
            throw failure;
        }
    }

    /**
     * Creates a robot as soon as its controller is ready, and moves it to its start pose, where it settles with all joints at 0.
     * The listener is not called until the robot has been moved.
     */
    private void enter(RobotStart start, Controller controller) {
        introduce(start, controller);
        AgentLink link = simulator.connect();
        TrialBody.create(link, start.type());
        for (int i = 0; i < CYCLES_TO_APPEAR; i++) {
            advance();
        }
        TrialBody body = new TrialBody(link, start, simulator.world().robots().get(bodies.size()), controller);
        bodies.add(body);
        body.join();
        advance();
        simulator.match().setPlayMode(PlayMode.PLAY_ON);
        move(body, start.place());
        for (int i = 0; i < CYCLES_TO_SETTLE; i++) {
            if (i < CYCLES_TO_JOIN || i >= CYCLES_TO_SETTLE - CYCLES_TO_WAKE) {
                controller.awake(body.readings());
            }
            exchange();
        }
    }

    private void introduce(RobotStart start, Controller controller) {
        boolean first = start.team().equals(scene.robots().get(0).team());
        controller.embody(start.type());
        controller.introduce(start.team(), start.number(), first ? TeamSide.LEFT : TeamSide.RIGHT);
    }

    /** Plays the prelude of one robot while the others hold still. */
    private void playPrelude(TrialBody body) {
        Controller own = body.controller();
        for (Motion motion : body.start().prelude()) {
            Controller player = Controller.ofMotion(motion);
            body.setController(player);
            do {
                perform(body);
            } while (!player.isFinished());
            for (int i = 0; i < CYCLES_TO_REST; i++) {
                perform(body);
            }
        }
        body.setController(own);
    }

    private void perform(TrialBody only) {
        bodies.forEach(TrialBody::idle);
        only.perform();
        cycle();
    }

    private void exchange() {
        advance();
        listener.cycleEnded(this);
    }

    private void advance() {
        bodies.forEach(TrialBody::idle);
        world.cycle(bodies);
    }

    private void cycle() {
        world.cycle(bodies);
        listener.cycleEnded(this);
    }

    /**
     * Allows robots to beam, subject to the referee's rules. By default, beams are ignored, because the scene defines the
     * start poses.
     */
    public void allowBeams() {
        bodies.forEach(TrialBody::allowBeams);
    }

    /**
     * Advances all controllers and the world by one cycle.
     *
     * @return the true state afterwards
     */
    public WorldState step() {
        bodies.forEach(TrialBody::perform);
        cycles++;
        cycle();
        hook.act(this);
        return now();
    }

    /** Saves the current state as the start of the trial, to which {@link #reset} returns. */
    public void keep() {
        cycles = 0;
        world.keep();
        firstReadings = bodies.stream().map(TrialBody::readings).toList();
    }

    /**
     * Resets a direct trial to its start, which is much faster than creating a new one.
     *
     * @param seed new seed for all noise
     * @param controllers a new controller for each robot
     */
    public void reset(long seed, Controller... controllers) {
        Iterator<Controller> all = each(scene, controllers);
        world.reset(seed);
        setGrip(1);
        bodies.forEach(body -> body.robot().restoreProperties());
        hook = trial -> {};
        cycles = 0;
        for (int i = 0; i < bodies.size(); i++) {
            TrialBody body = bodies.get(i);
            Controller controller = all.next();
            introduce(body.start(), controller);
            body.setController(controller);
            body.setReadings(firstReadings.get(i));
        }
    }

    /**
     * Sets a hook for external events, such as pushes or a shot.
     *
     * @param newHook called after each cycle
     * @return this trial
     */
    public Trial with(TrialHook newHook) {
        hook = newHook;
        return this;
    }

    /**
     * Replaces the physics engine until the trial is reset. Requires a direct trial with one robot.
     *
     * @param physics computes the motion of each cycle
     */
    public void setPhysics(ExternalPhysics physics) {
        world.setPhysics(physics);
    }

    /**
     * Executes a human referee's command, such as a kick-off, before the next cycle. Requires a served trial, because
     * only served trials have a referee.
     *
     * @param order the command
     */
    public void order(Order order) {
        simulator.order(order);
    }

    /**
     * Runs until the time is up or a measure is decided. The measures observe the current state first.
     *
     * @param seconds end of the run, in simulated seconds since the start of the trial
     * @param measures the measures
     */
    public void run(double seconds, Measure... measures) {
        List<Measure> all = List.of(measures);
        WorldState first = now();
        all.forEach(measure -> measure.see(first));
        while (seconds() < seconds && all.stream().noneMatch(Measure::isDecided)) {
            WorldState state = step();
            all.forEach(measure -> measure.see(state));
        }
    }

    /** {@return the current true state} */
    public WorldState now() {
        MatchState game = simulator.match().state();
        return new WorldState(
                seconds(),
                bodies.stream().map(body -> body.robot().body()).toList(),
                ball().position(),
                ball().velocity(),
                simulator.world().things().now(),
                game.playMode(),
                game.score(TeamSide.LEFT),
                game.score(TeamSide.RIGHT));
    }

    /** {@return simulated seconds since the start of the trial} */
    public double seconds() {
        return cycles * Cycle.SECONDS;
    }

    /**
     * Scales the friction of all surfaces until the trial ends or is reset.
     *
     * @param factor friction relative to SimSpark's, above 0; at 0.5, feet slip twice as fast as at 1 under the same
     *     force
     */
    public void setGrip(double factor) {
        simulator.world().setGrip(factor);
    }

    /** {@return the ball} */
    public Ball ball() {
        return simulator.world().ball();
    }

    /**
     * Returns a robot.
     *
     * @param index the robot's index in the scene
     * @return the robot in the simulated world
     */
    public Robot robot(int index) {
        return bodies.get(index).robot();
    }

    /**
     * Returns the readings to which a robot's controller responds in the next cycle.
     *
     * @param index the robot's index in the scene
     * @return the readings, valid until the next cycle
     */
    public SensorReadings readings(int index) {
        return bodies.get(index).readings();
    }

    /**
     * Places the ball on the ground, at rest.
     *
     * @param place its position, whose height is ignored
     */
    public void placeBall(Vector3 place) {
        ball().place(new Vector3(place.x(), place.y(), ball().properties().radius()));
    }

    /**
     * Moves a robot to an upright pose without changing its joint angles.
     *
     * @param index the robot's index in the scene
     * @param place its new pose
     */
    public void moveRobot(int index, Pose2d place) {
        move(bodies.get(index), place);
    }

    private static void move(TrialBody body, Pose2d place) {
        body.robot().moveUpright(new Vector3(place.x(), place.y(), TORSO_METRES), place.degrees() - 90);
        body.robot().wake();
    }

    /**
     * Returns the voice message that a robot sent in this cycle.
     *
     * @param index the robot's index in the scene
     * @return the text; empty if it sent none
     */
    public Optional<String> said(int index) {
        return bodies.get(index).commands().stream()
                .filter(EffectorCommand.Say.class::isInstance)
                .map(say -> ((EffectorCommand.Say) say).text())
                .findFirst();
    }

    /**
     * Takes a snapshot of the world for observers.
     *
     * @param paused whether the trial is paused
     * @param speed simulated seconds per real second
     * @return the current state
     */
    public WorldSnapshot snapshot(boolean paused, double speed) {
        return simulator.snapshot(paused, speed);
    }

    @Override
    public void close() {
        bodies.forEach(TrialBody::close);
        simulator.close();
    }
}

package org.robonewbie.simulator.world;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.robot.NaoRobot;
import org.robonewbie.robot.RobotModel;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.physics.Crew;
import org.robonewbie.simulator.physics.PhysicsWorld;
import org.robonewbie.simulator.physics.sparse.SparsePhysicsWorld;
import org.robonewbie.simulator.state.WorldState;

/**
 * Physical world of SimSpark's soccer simulation: ground, walls, goals, ball, robots and the objects of a landscape.
 *
 * <p>It has no rules, clock or randomness: the same calls in the same order produce bit-identical worlds. Not
 * thread-safe. A world need not be closed.
 *
 * <pre>{@code
 * SoccerWorld world = new SoccerWorld(SoccerField.LEAGUE);
 * Robot robot = world.addRobot(RobotType.TYPE_0);
 * robot.moveUpright(new Vector3(-5, 0, 0.4), -90);
 * world.step();
 * }</pre>
 */
public final class SoccerWorld implements Restorable {

    private static final int NAO_TYPES = RobotType.values().length;

    private final SoccerField field;
    private final PhysicsWorld engine;
    private final Ball ball;
    private final PlacedThings things;
    /** Models other than the NAO's that robots of this world have or had. */
    private final Set<RobotModel> models = new LinkedHashSet<>();

    private final List<Robot> robots = new ArrayList<>();
    private final List<Robot> readOnlyRobots = Collections.unmodifiableList(robots);
    private final ContactReport report = new ContactReport();

    /**
     * Creates a bare pitch with the standard ball on the centre spot.
     *
     * @param field dimensions of the pitch
     */
    public SoccerWorld(SoccerField field) {
        this(field, BallProperties.STANDARD, new SparsePhysicsWorld(), Landscape.SOCCER);
    }

    /**
     * Creates a pitch with a ball on the centre spot.
     *
     * @param field dimensions of the pitch
     * @param ballProperties radius and mass of the ball
     * @param engine an empty physics world
     * @param landscape the objects on the pitch
     */
    public SoccerWorld(SoccerField field, BallProperties ballProperties, PhysicsWorld engine, Landscape landscape) {
        this.field = field;
        this.engine = engine;
        new Pitch(engine, field, ballProperties.radius()).build();
        this.ball = new Ball(engine.scenery(), ballProperties);
        this.things = new PlacedThings(engine.scenery(), landscape);
    }

    /** {@return the dimensions of the pitch} */
    public SoccerField field() {
        return field;
    }

    /** {@return the ball} */
    public Ball ball() {
        return ball;
    }

    /** {@return the objects on the pitch} */
    public PlacedThings things() {
        return things;
    }

    /**
     * Adds a robot, which appears upright above the ground at {@link Robot#START_POSITION} and falls.
     *
     * @param type robot type
     * @return the new robot
     */
    public Robot addRobot(RobotType type) {
        return addRobot(NaoRobot.of(type));
    }

    /**
     * Adds a robot of any model, which appears upright above the ground at {@link Robot#START_POSITION} and falls. All joints are at
     * 0° and hold that angle until their motors are commanded.
     *
     * @param model the model
     * @return the new robot
     * @throws IllegalArgumentException if the model cannot be simulated; the message says why
     */
    public Robot addRobot(RobotModel model) {
        RobotBuilder.check(model);
        Robot robot = new Robot(engine.addAssembly(), model);
        if (!robot.isNao()) {
            models.add(model);
        }
        robots.add(robot);
        return robot;
    }

    /**
     * Removes a robot from the world. It must not be used afterwards.
     *
     * @param robot a robot of this world
     */
    public void removeRobot(Robot robot) {
        if (robots.remove(robot)) {
            robot.remove();
            report.forget(robot);
        }
    }

    /** {@return the robots in the order in which they were added, unmodifiable} */
    public List<Robot> robots() {
        return readOnlyRobots;
    }

    /**
     * Scales the grip of all surfaces. The factor is not part of a saved state.
     *
     * @param factor above 0; 1 is SimSpark's grip, and at 0.5 surfaces slip twice as fast as at 1 under the same force
     */
    public void setGrip(double factor) {
        engine.setGrip(factor);
    }

    /**
     * Sets the executor for the following steps. Results stay bit-identical.
     *
     * @param crew executor; initially {@link Crew#ALONE}
     */
    public void setCrew(Crew crew) {
        engine.setCrew(crew);
    }

    /** Advances the world by one cycle of 20 ms: accelerometers, beams, drag, contacts, motion, foot sensors. */
    public void step() {
        prepareStep();
        engine.step(Cycle.SECONDS);
        ball.finishStep();
        things.finishStep();
        robots.forEach(Robot::finishStep);
    }

    /**
     * Advances the world by one cycle, in which another physics engine computes motion and forces.
     *
     * @param other places the robots and the ball and sets foot forces
     */
    public void step(Runnable other) {
        prepareStep();
        other.run();
        robots.forEach(Robot::forgetExternalForces);
    }

    private void prepareStep() {
        ball.applyDrag();
        robots.forEach(Robot::prepareStep);
        engine.findContacts();
        report.read(engine.contacts());
    }

    /**
     * {@return for each robot that touched the ball in the last step, the first link that did, in the order of the
     * contacts}
     */
    public List<RobotPart> ballTouches() {
        return report.ballTouches();
    }

    /**
     * Returns whether the ball was inside a goal at the beginning of the last step.
     *
     * @param side side of the goal
     * @return whether the ball touched the box that fills the goal
     */
    public boolean isBallInGoal(TeamSide side) {
        return report.isBallInGoal(side);
    }

    /**
     * {@return the contact points between robots in the last step, in the order of the contacts}
     */
    public List<RobotContact> robotContacts() {
        return report.robotContacts();
    }

    /**
     * Saves everything that moves. Call between two steps.
     *
     * @return the state, from which any world with the same settings continues bit-identically
     * @throws UnsupportedOperationException if the physics engine cannot be saved
     */
    public WorldState save() {
        return WorldState.of(settings(), this);
    }

    /**
     * Restores a saved state. Existing robots are kept up to the first one whose model differs from the saved one; the
     * rest are removed, and missing robots are added.
     *
     * @param state the state of a world with the same settings
     * @throws IllegalArgumentException if the settings differ; the message describes the difference
     */
    public void restore(WorldState state) {
        state.restore(settings(), this);
    }

    /** {@return the settings that must match between a saved and a restored world, one per line} */
    public String settings() {
        String pitch = field + "\n" + ball.properties();
        return things.landscape().isBare() ? pitch : pitch + "\n" + things.landscape();
    }

    @Override
    public void save(StateWriter out) {
        out.putAll(robots, robot -> saveModel(robot, out));
        engine.save(out);
        robots.forEach(robot -> robot.save(out));
        report.save(out, robots);
    }

    @Override
    public void restore(StateReader in) {
        matchRobots(in.getAll(() -> restoreModel(in)));
        engine.restore(in);
        robots.forEach(robot -> robot.restore(in));
        report.restore(in, robots);
    }

    /** Saves the index of a NAO's type, or a larger index and the name of another model. */
    private static void saveModel(Robot robot, StateWriter out) {
        if (robot.isNao()) {
            out.putEnum(robot.type());
        } else {
            out.putInt(NAO_TYPES);
            out.putText(robot.model().name());
        }
    }

    private RobotModel restoreModel(StateReader in) {
        int type = in.getIndex(NAO_TYPES + 1);
        if (type < NAO_TYPES) {
            return NaoRobot.of(RobotType.values()[type]);
        }
        String name = in.getText();
        return models.stream()
                .filter(model -> model.name().equals(name))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("The state contains a robot of the model " + name
                        + ", which this world has never had. Add such a robot before restoring the state."));
    }

    private void matchRobots(List<RobotModel> saved) {
        int same = 0;
        while (same < Math.min(saved.size(), robots.size())
                && robots.get(same).model().equals(saved.get(same))) {
            same++;
        }
        List.copyOf(robots.subList(same, robots.size())).forEach(this::removeRobot);
        saved.subList(same, saved.size()).forEach(this::addRobot);
    }
}

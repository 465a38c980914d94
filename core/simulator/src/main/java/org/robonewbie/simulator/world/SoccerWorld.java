package org.robonewbie.simulator.world;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.physics.Crew;
import org.robonewbie.simulator.physics.PhysicsWorld;
import org.robonewbie.simulator.physics.sparse.SparsePhysicsWorld;
import org.robonewbie.simulator.state.WorldState;

/**
 * The physical world of SimSpark's soccer simulation: ground, walls, goals, ball, robots, and the things of a
 * landscape.
 *
 * <p>It knows no rules, no time and no randomness: equal calls in equal order give bit-identical worlds. One thread at a
 * time. Dropping a world frees it.
 *
 * <pre>{@code
 * SoccerWorld world = new SoccerWorld(SoccerField.LEAGUE);
 * Robot robot = world.addRobot(RobotType.TYPE_0);
 * robot.moveUpright(new Vector3(-5, 0, 0.4), -90);
 * world.step();
 * }</pre>
 */
public final class SoccerWorld implements Restorable {

    private final SoccerField field;
    private final PhysicsWorld engine;
    private final Ball ball;
    private final PlacedThings things;
    private final List<Robot> robots = new ArrayList<>();
    private final List<Robot> readOnlyRobots = Collections.unmodifiableList(robots);
    private final ContactReport report = new ContactReport();

    /**
     * Creates a pitch with the standard ball in its middle.
     *
     * @param field dimensions of the pitch
     */
    public SoccerWorld(SoccerField field) {
        this(field, BallProperties.STANDARD);
    }

    /**
     * Creates a pitch with a ball in its middle.
     *
     * @param field dimensions of the pitch
     * @param ballProperties radius and mass of the ball
     */
    public SoccerWorld(SoccerField field, BallProperties ballProperties) {
        this(field, ballProperties, new SparsePhysicsWorld());
    }

    /**
     * Creates a pitch in a given engine.
     *
     * @param field dimensions of the pitch
     * @param ballProperties radius and mass of the ball
     * @param engine an empty world
     */
    public SoccerWorld(SoccerField field, BallProperties ballProperties, PhysicsWorld engine) {
        this(field, ballProperties, engine, Landscape.SOCCER);
    }

    /**
     * Creates a pitch in a given engine with things on it.
     *
     * @param field dimensions of the pitch
     * @param ballProperties radius and mass of the ball
     * @param engine an empty world
     * @param landscape what stands on the pitch
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

    /** {@return what else stands on the pitch} */
    public PlacedThings things() {
        return things;
    }

    /**
     * Adds a robot; it appears upright above the ground at {@link Robot#START_POSITION} and falls.
     *
     * @param type its build
     * @return the new robot
     */
    public Robot addRobot(RobotType type) {
        Robot robot = new Robot(engine.addAssembly(), type);
        robots.add(robot);
        return robot;
    }

    /**
     * Takes a robot out of the world; it must not be used afterwards.
     *
     * @param robot a robot of this world
     */
    public void removeRobot(Robot robot) {
        if (robots.remove(robot)) {
            robot.remove();
            report.forget(robot);
        }
    }

    /** {@return all robots in the order in which they were added, unmodifiable} */
    public List<Robot> robots() {
        return readOnlyRobots;
    }

    /**
     * Changes how well all surfaces hold on to each other, to try robots on other grounds; no part of a saved state.
     *
     * @param factor above 0; 1 as in SimSpark, with 0.5 they slip twice as fast under the same force
     */
    public void setGrip(double factor) {
        engine.setGrip(factor);
    }

    /**
     * Lets others help with the next steps; what happens stays the same to the bit.
     *
     * @param crew who does the work; {@link Crew#ALONE} at first
     */
    public void setCrew(Crew crew) {
        engine.setCrew(crew);
    }

    /** Advances the world by one cycle of 20 ms: accelerometers, beams, drag, contacts, movement, foot sensors. */
    public void step() {
        ball.applyDrag();
        robots.forEach(Robot::prepareStep);
        engine.findContacts();
        report.read(engine.contacts());
        engine.step(Cycle.SECONDS);
        ball.finishStep();
        things.finishStep();
        robots.forEach(Robot::finishStep);
    }

    /**
     * {@return who touched the ball in the last step: for each robot the first part that touched, in the order in which the
     * contacts were found}
     */
    public List<RobotPart> ballTouches() {
        return report.ballTouches();
    }

    /**
     * Returns whether the ball was inside a goal at the beginning of the last step.
     *
     * @param side whose goal
     * @return true while the ball touches the box that fills the goal
     */
    public boolean isBallInGoal(TeamSide side) {
        return report.isBallInGoal(side);
    }

    /**
     * {@return where robots touched each other in the last step: one entry per contact point, in the order in which they were
     * found}
     */
    public List<RobotContact> robotContacts() {
        return report.robotContacts();
    }

    /**
     * Saves everything that moves, between two steps.
     *
     * @return the state, from which this world or another one like it continues to the bit
     * @throws UnsupportedOperationException if the physics engine cannot be saved
     */
    public WorldState save() {
        return WorldState.of(settings(), this);
    }

    /**
     * Continues from a saved state. Robots stay the same objects where their types agree with those of the state, in the order
     * in which they came into the world; the others are removed, and missing ones added.
     *
     * @param state the state of this world or of one with the same pitch and ball
     * @throws IllegalArgumentException if the state is that of another kind of world; the message says what differs
     */
    public void restore(WorldState state) {
        state.restore(settings(), this);
    }

    /** {@return what must agree between the world that is saved and the one that is restored, one setting in each line} */
    public String settings() {
        String pitch = field + "\n" + ball.properties();
        return things.landscape().isBare() ? pitch : pitch + "\n" + things.landscape();
    }

    @Override
    public void save(StateWriter out) {
        out.putAll(robots, robot -> out.putEnum(robot.model().type()));
        engine.save(out);
        robots.forEach(robot -> robot.save(out));
        report.save(out, robots);
    }

    @Override
    public void restore(StateReader in) {
        haveRobots(in.getAll(() -> in.getEnum(RobotType.values())));
        engine.restore(in);
        robots.forEach(robot -> robot.restore(in));
        report.restore(in, robots);
    }

    private void haveRobots(List<RobotType> types) {
        int same = 0;
        while (same < Math.min(types.size(), robots.size())
                && robots.get(same).model().type() == types.get(same)) {
            same++;
        }
        List.copyOf(robots.subList(same, robots.size())).forEach(this::removeRobot);
        types.subList(same, types.size()).forEach(this::addRobot);
    }
}

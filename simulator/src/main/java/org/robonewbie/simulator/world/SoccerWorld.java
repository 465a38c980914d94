package org.robonewbie.simulator.world;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.physics.PhysicsWorld;

/**
 * The physical world of SimSpark's soccer simulation: ground, walls, goals, ball and robots.
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
public final class SoccerWorld {

    /** Length of one step in seconds. */
    public static final double STEP_SECONDS = 0.02;

    private final SoccerField field;
    private final PhysicsWorld engine;
    private final Ball ball;
    private final List<Robot> robots = new ArrayList<>();
    private final ContactReport report = new ContactReport();

    /**
     * Makes a pitch with the standard ball in its middle.
     *
     * @param field sizes of the pitch
     */
    public SoccerWorld(SoccerField field) {
        this(field, BallProperties.STANDARD);
    }

    /**
     * Makes a pitch with a ball in its middle.
     *
     * @param field sizes of the pitch
     * @param ballProperties size and weight of the ball
     */
    public SoccerWorld(SoccerField field, BallProperties ballProperties) {
        this(field, ballProperties, PhysicsEngine.STANDARD.newWorld());
    }

    /**
     * Makes a pitch in an engine of choice.
     *
     * @param field sizes of the pitch
     * @param ballProperties size and weight of the ball
     * @param engine an empty world
     */
    public SoccerWorld(SoccerField field, BallProperties ballProperties, PhysicsWorld engine) {
        this.field = field;
        this.engine = engine;
        new Pitch(engine, field, ballProperties.radius()).build();
        this.ball = new Ball(engine.scenery(), ballProperties);
    }

    /**
     * Tells the sizes of the pitch.
     *
     * @return the field
     */
    public SoccerField field() {
        return field;
    }

    /**
     * Gives access to the ball.
     *
     * @return the only ball
     */
    public Ball ball() {
        return ball;
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

    /**
     * Lists the robots.
     *
     * @return all robots in the order in which they were added, unmodifiable
     */
    public List<Robot> robots() {
        return Collections.unmodifiableList(robots);
    }

    /** Advances the world by one cycle of 20 ms: accelerometers, beams, drag, contacts, movement, foot sensors. */
    public void step() {
        ball.applyDrag();
        robots.forEach(Robot::prepareStep);
        engine.findContacts();
        report.read(engine.contacts());
        engine.step(STEP_SECONDS);
        ball.finishStep();
        robots.forEach(Robot::finishStep);
    }

    /**
     * Lists who touched the ball in the last step.
     *
     * @return for each robot the first part that touched, in the order in which the contacts were found
     */
    public List<RobotPart> ballTouches() {
        return report.ballTouches();
    }

    /**
     * Tells whether the ball was inside a goal at the beginning of the last step.
     *
     * @param side whose goal
     * @return true while the ball touches the box that fills the goal
     */
    public boolean isBallInGoal(TeamSide side) {
        return report.isBallInGoal(side);
    }

    /**
     * Lists where robots touched each other in the last step.
     *
     * @return one entry per contact point, in the order in which they were found
     */
    public List<RobotContact> robotContacts() {
        return report.robotContacts();
    }
}

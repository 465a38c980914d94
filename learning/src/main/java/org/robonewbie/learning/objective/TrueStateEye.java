package org.robonewbie.learning.objective;

import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.simulator.world.Ball;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.simulator.world.SoccerWorld;

/**
 * Looks into the simulated world and sees what is true of one robot. It looks once after each cycle, since it adds up the
 * work of the motors and remembers goals.
 */
public final class TrueStateEye {

    private final SoccerWorld world;
    private final Robot robot;
    private final TeamSide goal;
    private final LimbWork work;
    private long looks;
    private boolean scored;

    /**
     * Opens an eye upon a robot that plays towards the right end.
     *
     * @param world the world it lives in
     * @param robot the robot
     */
    public TrueStateEye(SoccerWorld world, Robot robot) {
        this(world, robot, TeamSide.RIGHT);
    }

    /**
     * Opens an eye upon a robot.
     *
     * @param world the world it lives in
     * @param robot the robot
     * @param goal the end of the pitch with the opponents' goal
     */
    public TrueStateEye(SoccerWorld world, Robot robot, TeamSide goal) {
        this.world = world;
        this.robot = robot;
        this.goal = goal;
        this.work = new LimbWork(robot);
    }

    /**
     * Looks at the world; the first look sees the time 0.
     *
     * @return what is true now
     */
    public TrueState look() {
        if (looks > 0) {
            work.add();
        }
        scored |= world.isBallInGoal(goal);
        Ball ball = world.ball();
        return new TrueState(
                looks++ * Cycle.SECONDS,
                robot.torso().position(),
                robot.torsoVelocity(),
                robot.headingDegrees(),
                robot.torso().rotation().zz(),
                robot.gyroDegreesPerSecond(),
                joints(),
                work.joules(),
                ball.position(),
                ball.velocity(),
                scored ? 0 : metresToGoal(ball.position()),
                scored);
    }

    private Posture joints() {
        double[] degrees = new double[Joint.COUNT];
        for (Joint joint : Joint.values()) {
            degrees[joint.ordinal()] = robot.jointDegrees(joint);
        }
        return Posture.of(degrees);
    }

    private double metresToGoal(Vector3 ball) {
        SoccerField field = world.field();
        double ahead = goal == TeamSide.RIGHT ? ball.x() : -ball.x();
        double missing = Math.max(0, field.length() / 2 - ahead);
        double aside = Math.max(0, Math.abs(ball.y()) - field.goalWidth() / 2);
        return Math.hypot(missing, aside);
    }
}

package org.robonewbie.studio.motion;

import java.util.Arrays;
import java.util.List;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Interpolation;
import org.robonewbie.nao.motion.JointStates;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.MotionPlayer;
import org.robonewbie.nao.motion.Motors;
import org.robonewbie.protocol.effector.EffectorMessageWriter;
import org.robonewbie.protocol.perceptor.PerceptorMessageWriter;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.simulator.world.SoccerWorld;

/**
 * A robot alone in a world of its own that plays motions as an agent's robot does: with the same motors, numbers rounded as in
 * messages, and speeds that act one cycle after they were sent.
 */
final class TrialRobot {

    private static final Vector3 START = new Vector3(0, 0, 0.39);
    private static final Vector3 BALL_ASIDE = new Vector3(-5, -3.5, 0.042);
    private static final double NO_COMMAND = Double.NaN;
    private static final Motion NOTHING = new Motion("hold", List.of());

    private final SoccerWorld world = new SoccerWorld(SoccerField.BEGINNER);
    private final Robot robot = world.addRobot(RobotType.TYPE_0);
    private final JointStates joints = new JointStates();
    private final Motors motors = new Motors(joints);
    private final double[] radiansPerSecondUnderWay = new double[Joint.COUNT];

    /** Puts the robot down upright at the origin; it looks along the y axis. */
    TrialRobot() {
        robot.moveUpright(START, 0);
        world.ball().place(BALL_ASIDE);
        Arrays.fill(radiansPerSecondUnderWay, NO_COMMAND);
        sense();
    }

    /** The body in its world. */
    Robot body() {
        return robot;
    }

    /** Plays a motion and calls after each cycle. */
    void play(Motion motion, Runnable afterCycle) {
        MotionPlayer player = new MotionPlayer(motion, Interpolation.LINEAR);
        while (!player.isFinished()) {
            cycle(player);
            afterCycle.run();
        }
    }

    /** Holds all joints still. */
    void hold(double seconds, Runnable afterCycle) {
        MotionPlayer player = new MotionPlayer(NOTHING, Interpolation.LINEAR);
        for (long i = Math.round(seconds / Cycle.SECONDS); i > 0; i--) {
            cycle(player);
            afterCycle.run();
        }
    }

    private void cycle(MotionPlayer player) {
        player.step(motors);
        motors.endCycle();
        for (Joint joint : Joint.values()) {
            robot.setMotorSpeed(joint, radiansPerSecondUnderWay[joint.ordinal()]);
            radiansPerSecondUnderWay[joint.ordinal()] = motors.needsCommand(joint)
                    ? EffectorMessageWriter.rounded(Math.toRadians(motors.sentDegreesPerSecond(joint)))
                    : NO_COMMAND;
        }
        world.step();
        sense();
    }

    private void sense() {
        for (Joint joint : Joint.values()) {
            joints.sense(joint, PerceptorMessageWriter.rounded(robot.jointDegrees(joint)));
        }
    }
}

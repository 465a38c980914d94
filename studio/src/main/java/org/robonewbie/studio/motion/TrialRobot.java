package org.robonewbie.studio.motion;

import java.util.List;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Interpolation;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.MotionCourse;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.simulator.world.SoccerWorld;

/**
 * A robot alone in a world of its own that plays motions as an agent does: it senses its joints in hundredths of a degree,
 * corrects half of what is missing in each cycle, and a speed acts one cycle after it was sent.
 */
final class TrialRobot {

    private static final Vector3 START = new Vector3(0, 0, 0.39);
    private static final Vector3 BALL_ASIDE = new Vector3(-5, -3.5, 0.042);
    private static final Joint[] JOINTS = Joint.values();
    private static final int CYCLE_MILLIS = 20;
    private static final double CORRECTION = 0.5;
    private static final double MARGIN_DEGREES = 0.1;

    private final SoccerWorld world = new SoccerWorld(SoccerField.BEGINNER);
    private final Robot robot = world.addRobot(RobotType.TYPE_0);
    private final double[] sensed = new double[Joint.COUNT];
    private final double[] sent = new double[Joint.COUNT];
    private final double[] onTheWay = new double[Joint.COUNT];

    /** Puts the robot down upright at the origin; it looks along the y axis. */
    TrialRobot() {
        robot.moveUpright(START, 0);
        world.ball().place(BALL_ASIDE);
        sense();
    }

    /** The body in its world. */
    Robot body() {
        return robot;
    }

    /** Plays a motion and calls after each cycle. */
    void play(Motion motion, Runnable afterCycle) {
        MotionCourse course = new MotionCourse(expected(), motion, Interpolation.LINEAR);
        long cycles = Math.max(1, Math.round((double) motion.durationMillis() / CYCLE_MILLIS));
        double[] planned = course.start().toArray();
        for (long cycle = 1; cycle <= cycles; cycle++) {
            Posture next = course.postureAt((double) cycle * CYCLE_MILLIS);
            steer(planned, next, cycle == cycles ? 1 : CORRECTION);
            cycle();
            afterCycle.run();
        }
    }

    /** Holds all joints still. */
    void hold(double seconds, Runnable afterCycle) {
        play(new Motion("hold", List.of(new Keyframe((int) (1000 * seconds), expected()))), afterCycle);
    }

    private void steer(double[] planned, Posture next, double correction) {
        for (Joint joint : JOINTS) {
            int i = joint.ordinal();
            double wanted = inside(joint, next.degrees(joint));
            double error = planned[i] - expectedDegrees(i);
            double speed = (wanted - planned[i] + correction * error) / WorldSnapshot.CYCLE_SECONDS;
            double most = joint.maxDegreesPerSecond();
            sent[i] = Math.max(-most, Math.min(most, speed));
            planned[i] = wanted;
        }
    }

    private void cycle() {
        for (Joint joint : JOINTS) {
            robot.setMotorSpeed(joint, Math.toRadians(onTheWay[joint.ordinal()]));
            onTheWay[joint.ordinal()] = sent[joint.ordinal()];
        }
        world.step();
        sense();
    }

    private void sense() {
        for (Joint joint : JOINTS) {
            sensed[joint.ordinal()] = Math.round(robot.jointDegrees(joint) * 100) / 100.0;
        }
    }

    private double expectedDegrees(int joint) {
        return sensed[joint] + sent[joint] * WorldSnapshot.CYCLE_SECONDS;
    }

    private Posture expected() {
        double[] degrees = new double[Joint.COUNT];
        for (int i = 0; i < degrees.length; i++) {
            degrees[i] = expectedDegrees(i);
        }
        return Posture.of(degrees);
    }

    private static double inside(Joint joint, double degrees) {
        return Math.max(joint.minDegrees() + MARGIN_DEGREES, Math.min(joint.maxDegrees() - MARGIN_DEGREES, degrees));
    }
}

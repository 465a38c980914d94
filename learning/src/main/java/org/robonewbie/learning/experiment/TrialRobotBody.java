package org.robonewbie.learning.experiment;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.SimSparkFrame;
import org.robonewbie.nao.motion.JointStates;
import org.robonewbie.nao.motion.Motors;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.protocol.perceptor.Vision;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.sensing.Camera;
import org.robonewbie.simulator.sensing.CameraSettings;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.simulator.world.SoccerWorld;

/** One robot of a trial: what was commanded and does not act yet, and what it has sensed. */
final class TrialRobotBody {

    private static final double TORSO_METRES = 0.39;
    private static final Joint[] JOINTS = Joint.values();

    private final SoccerWorld world;
    private final Robot robot;
    private final Optional<Camera> camera;
    private final Perception perception;
    private final JointStates joints = new JointStates();
    private final Motors motors = new Motors(joints);
    private final Posture firstPosture;
    private final double[] onTheWay = new double[Joint.COUNT];
    private final double[] degrees = new double[Joint.COUNT];
    private final double[] degreesBefore = new double[Joint.COUNT];

    TrialRobotBody(SoccerWorld world, TrialSetting setting, RobotStart start, SplittableRandom random) {
        this.world = world;
        this.robot = world.addRobot(start.type());
        this.perception = new Perception(robot, setting.camera());
        double x = start.xMetres() + spread(random, setting.placeSpreadMetres());
        double y = start.yMetres() + spread(random, setting.placeSpreadMetres());
        double heading = start.headingDegrees() + spread(random, setting.headingSpreadDegrees());
        robot.moveUpright(new Vector3(x, y, TORSO_METRES), heading - 90);
        this.firstPosture = near(start.posture(), random, setting.jointSpreadDegrees());
        CameraSettings eyes = CameraSettings.STANDARD.withLines(false).withNoise(setting.cameraNoise());
        this.camera =
                setting.camera() ? Optional.of(new Camera(world.field(), eyes, random.split())) : Optional.empty();
        sense(false);
    }

    private static Posture near(Posture posture, SplittableRandom random, double degrees) {
        double[] angles = posture.toArray();
        for (int i = 0; i < angles.length; i++) {
            angles[i] = JOINTS[i].clampDegrees(angles[i] + spread(random, degrees));
        }
        return Posture.of(angles);
    }

    private static double spread(SplittableRandom random, double most) {
        return most * (2 * random.nextDouble() - 1);
    }

    /** Leads the joints from 0 to the first posture. */
    void settle(double progress) {
        double[] speeds = new double[Joint.COUNT];
        for (Joint joint : JOINTS) {
            motors.setTarget(joint, progress * firstPosture.degrees(joint), joint.maxDegreesPerSecond());
        }
        motors.endCycle();
        for (Joint joint : JOINTS) {
            speeds[joint.ordinal()] = motors.sentDegreesPerSecond(joint);
        }
        command(speeds);
    }

    /** Forgets how the robot came to its place. */
    void begin() {
        perception.look(camera.map(this::picture));
    }

    /** Applies the last command and keeps the new one for the next cycle. */
    void command(double[] degreesPerSecond) {
        for (Joint joint : JOINTS) {
            robot.setMotorSpeed(joint, Math.toRadians(onTheWay[joint.ordinal()]));
            onTheWay[joint.ordinal()] = degreesPerSecond[joint.ordinal()];
        }
    }

    /** Takes in what the last step has changed. */
    void sense(boolean withPicture) {
        for (Joint joint : JOINTS) {
            int i = joint.ordinal();
            degreesBefore[i] = degrees[i];
            degrees[i] = robot.jointDegrees(joint);
            joints.sense(joint, Perception.hundredths(degrees[i]));
        }
        if (withPicture) {
            perception.look(camera.map(this::picture));
        }
    }

    private Vision picture(Camera eyes) {
        return eyes.look(robot, world, List.of(), Optional.empty());
    }

    double[] observation() {
        return perception.observation(degrees);
    }

    RobotState state() {
        List<BodyPose> links = new ArrayList<>();
        for (int i = 0; i < robot.model().links().size(); i++) {
            links.add(robot.linkPose(i));
        }
        double[] rates = new double[Joint.COUNT];
        for (int i = 0; i < rates.length; i++) {
            rates[i] = (degrees[i] - degreesBefore[i]) / Cycle.SECONDS;
        }
        return new RobotState(
                robot.model().type(),
                links,
                robot.torsoVelocity(),
                SimSparkFrame.toBody(robot.gyroDegreesPerSecond()),
                degrees.clone(),
                rates);
    }
}

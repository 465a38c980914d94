package org.robonewbie.nao.kinematics;

import java.util.function.IntToDoubleFunction;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Posture;

/**
 * The true state of a robot's body: the pose of its torso on the pitch and its joint angles, from which forward kinematics
 * calculates everything else. Immutable.
 *
 * <pre>{@code
 * BodyState body = robot.body();
 * if (!body.isFallen()) {
 *     double height = body.limbs().camera().position().z();
 * }
 * }</pre>
 *
 * <p>The world frame has its origin at the centre spot, x towards the right goal, y to the left of that direction, and
 * z up. The axes of the torso are those of the body frame: x forward, y left, z up.
 */
public final class BodyState {

    /** Tilt of the torso beyond which a robot counts as fallen, in degrees. */
    public static final double FALLEN_DEGREES = 60;

    /** Height of the torso's centre below which a robot counts as fallen, in metres. */
    public static final double FALLEN_METRES = 0.2;

    /** Tilt of the torso below which a robot can be on its feet, in degrees. */
    public static final double STANDING_DEGREES = 30;

    private static final double STANDING_METRES = 0.25;
    private static final Vector3 FORWARD = new Vector3(1, 0, 0);
    private static final Vector3 UP = new Vector3(0, 0, 1);

    private final NaoModel model;
    private final Pose torso;
    private final double[] hingeDegrees;

    private BodyState(NaoModel model, Pose torso, double[] hingeDegrees) {
        this.model = model;
        this.torso = torso;
        this.hingeDegrees = hingeDegrees;
    }

    /**
     * Creates the state of a body with straight toes, if it has toes.
     *
     * @param type the robot type
     * @param torso pose of the torso in the world frame
     * @param joints the joint angles
     * @return the state
     */
    public static BodyState of(RobotType type, Pose torso, Posture joints) {
        NaoModel model = NaoModel.of(type);
        return new BodyState(model, torso, ForwardKinematics.of(type).hingeDegrees(joints));
    }

    /**
     * Creates the state of a body from the angles of all its hinges, toes included.
     *
     * @param type the robot type
     * @param torso pose of the torso in the world frame
     * @param hingeDegrees angle of each hinge in the order of {@link NaoModel#hinges()}; copied
     * @return the state
     * @throws IllegalArgumentException if the number of angles differs from the number of hinges
     */
    public static BodyState ofHinges(RobotType type, Pose torso, double[] hingeDegrees) {
        NaoModel model = NaoModel.of(type);
        if (hingeDegrees.length != model.hinges().size()) {
            throw new IllegalArgumentException("Expected " + model.hinges().size()
                    + " angles, one for each hinge of robot " + type + ", but got " + hingeDegrees.length + ".");
        }
        return new BodyState(model, torso, hingeDegrees.clone());
    }

    /**
     * Creates the state of a body by measuring all its hinges, toes included.
     *
     * @param type the robot type
     * @param torso pose of the torso in the world frame
     * @param hingeDegrees function from the index of a hinge in {@link NaoModel#hinges()} to its angle in degrees
     * @return the state
     */
    public static BodyState measured(RobotType type, Pose torso, IntToDoubleFunction hingeDegrees) {
        NaoModel model = NaoModel.of(type);
        double[] degrees = new double[model.hinges().size()];
        for (int hinge = 0; hinge < degrees.length; hinge++) {
            degrees[hinge] = hingeDegrees.applyAsDouble(hinge);
        }
        return new BodyState(model, torso, degrees);
    }

    /** {@return the robot type} */
    public RobotType type() {
        return model.type();
    }

    /** {@return the torso's pose in the world frame} */
    public Pose torso() {
        return torso;
    }

    /** {@return the centre of the torso in the world frame, metres} */
    public Vector3 position() {
        return torso.position();
    }

    /**
     * Returns a joint angle.
     *
     * @param joint the joint
     * @return its angle in degrees
     */
    public double degrees(Joint joint) {
        return hingeDegrees[model.hingeIndex(joint)];
    }

    /**
     * Returns the angle of a hinge.
     *
     * @param hinge its index in {@link NaoModel#hinges()}
     * @return its angle in degrees
     */
    public double hingeDegrees(int hinge) {
        return hingeDegrees[hinge];
    }

    /** {@return the number of hinges} */
    public int hinges() {
        return hingeDegrees.length;
    }

    /** {@return the angles of all hinges in degrees, in the order of {@link NaoModel#hinges()}; a copy} */
    public double[] hingeDegrees() {
        return hingeDegrees.clone();
    }

    /** {@return the angles of the 22 joints} */
    public Posture joints() {
        double[] degrees = new double[Joint.COUNT];
        for (Joint joint : Joint.values()) {
            degrees[joint.ordinal()] = degrees(joint);
        }
        return Posture.of(degrees);
    }

    /** {@return the heading of the torso, as defined by {@link #headingDegrees(Vector3)}} */
    public double headingDegrees() {
        return headingDegrees(torso.rotation().apply(FORWARD));
    }

    /** {@return the tilt of the torso in degrees, in any direction: 0 upright, 90 lying, 180 upside down} */
    public double tiltDegrees() {
        return tiltDegrees(torso.rotation().apply(UP));
    }

    /** {@return whether the torso is tilted by more than 60 degrees or its centre is lower than 0.2 m} */
    public boolean isFallen() {
        return isFallen(tiltDegrees(), position().z());
    }

    /** {@return whether the robot is on its feet: tilted by less than 30 degrees and the torso higher than 0.25 m} */
    public boolean isStanding() {
        return isStanding(tiltDegrees(), position().z());
    }

    /** {@return the poses of all links in the world frame, recalculated on each call} */
    public BodyPoses limbs() {
        return ForwardKinematics.of(type()).poses(hingeDegrees).withTorso(torso);
    }

    /**
     * Returns the heading of a torso.
     *
     * @param forward the torso's forward axis in the world frame
     * @return heading in degrees, -180 to 180, 0 along the world's x axis, positive to the left
     */
    public static double headingDegrees(Vector3 forward) {
        return Angles.atan2(forward.y(), forward.x());
    }

    /**
     * Returns the tilt of a torso.
     *
     * @param up the torso's upward axis in the world frame, of length 1
     * @return angle to the vertical in degrees, 0 to 180
     */
    public static double tiltDegrees(Vector3 up) {
        return tiltDegrees(up.z());
    }

    /**
     * Returns the tilt of a torso.
     *
     * @param upwards vertical component of the torso's unit z axis, -1 to 1
     * @return angle to the vertical in degrees, 0 to 180
     */
    public static double tiltDegrees(double upwards) {
        return PortableMath.toDegrees(PortableMath.acos(Math.max(-1, Math.min(1, upwards))));
    }

    /**
     * Returns whether a robot has fallen. A robot that is sitting on the ground counts as fallen.
     *
     * @param tiltDegrees tilt of the torso in degrees
     * @param torsoMetres height of the torso's centre above the ground in metres
     * @return whether the tilt exceeds {@link #FALLEN_DEGREES} or the height is below {@link #FALLEN_METRES}
     */
    public static boolean isFallen(double tiltDegrees, double torsoMetres) {
        return tiltDegrees > FALLEN_DEGREES || torsoMetres < FALLEN_METRES;
    }

    /**
     * Returns whether a robot is on its feet, with straight or bent knees.
     *
     * @param tiltDegrees tilt of the torso in degrees
     * @param torsoMetres height of the torso's centre above the ground in metres
     * @return whether the tilt is below 30 degrees and the height above 0.25 m
     */
    public static boolean isStanding(double tiltDegrees, double torsoMetres) {
        return tiltDegrees < STANDING_DEGREES && torsoMetres > STANDING_METRES;
    }
}

package org.robonewbie.agent.localisation;

import java.util.Arrays;
import org.robonewbie.agent.Robot;
import org.robonewbie.agent.perception.FieldItem;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.kinematics.BodyPoses;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.kinematics.ForwardKinematics;
import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Posture;

/**
 * Odometry from the legs and the gyroscope: the support foot is assumed not to move, so the joint angles of its leg
 * determine the movement of the torso; the gyroscope measures the rotation. Feet slip, so the estimate drifts, but it
 * is accurate over a few seconds. Without force sensors in the feet, as on a T1, only the rotation is known.
 *
 * <pre>{@code
 * odometry.update(nao);                                      // in each cycle
 * Vector3 ball = odometry.positionNow(fieldView.ball());     // corrected for the movement since the sighting
 * }</pre>
 */
public final class Odometry {

    private static final int MEMORY_CYCLES = 3000;
    private static final double SOLE_BELOW_FOOT = 0.01;
    private static final Joint[] JOINTS = Joint.values();

    private final ForwardKinematics kinematics = ForwardKinematics.of(RobotType.TYPE_0);
    private final Pose2d[] history = new Pose2d[MEMORY_CYCLES];
    private Pose2d pose = Pose2d.ORIGIN;
    private Leg support = Leg.LEFT;
    private Pose2d torsoOnSupport = Pose2d.ORIGIN;
    private Vector3 step = Vector3.ZERO;
    private double height;
    private boolean begun;
    private boolean standing;

    /** Creates an odometry estimate that starts at the origin. */
    public Odometry() {
        Arrays.fill(history, pose);
    }

    /**
     * Adds the movement of one cycle. Call this method once at the beginning of each cycle.
     *
     * @param nao the robot
     */
    public void update(Robot nao) {
        BodyPoses body = kinematics.poses(posture(nao));
        Pose2d now = torsoOn(body, support);
        standing = begun && !nao.isFallen() && nao.getFootPressure(support).isPresent();
        step = standing ? torsoOnSupport.fromFrame(new Vector3(now.x(), now.y(), 0)) : Vector3.ZERO;
        begun = true;
        Vector3 place = pose.toFrame(step);
        pose = new Pose2d(
                place.x(), place.y(), Angles.wrap(pose.degrees() + nao.getGyro().z() * Cycle.SECONDS));
        history[index(nao.getTime())] = pose;
        support = load(nao, Leg.LEFT) >= load(nao, Leg.RIGHT) ? Leg.LEFT : Leg.RIGHT;
        torsoOnSupport = torsoOn(body, support);
        height = body.foot(support).inverse().position().z() + SOLE_BELOW_FOOT;
    }

    /** {@return whether a foot is known to be on the ground, so that {@link #step} is valid} */
    boolean isStanding() {
        return standing;
    }

    /**
     * {@return the movement of the torso in the last cycle, in the frame of the support foot: x forward, y left, in
     * metres}
     */
    Vector3 step() {
        return step;
    }

    /** {@return the height of the torso's centre above the sole of the support foot, in metres} */
    double height() {
        return height;
    }

    /** {@return the robot's pose relative to its pose at the first update} */
    public Pose2d pose() {
        return pose;
    }

    /**
     * Returns the current position of a stationary object, based on a sighting within the last minute.
     *
     * @param item a known object
     * @return the position relative to the centre of the head, in metres: x forward, y left, z up
     */
    public Vector3 positionNow(FieldItem item) {
        Pose2d then = item.isKnown() ? history[index(item.lastSeenSeconds())] : pose;
        return pose.fromFrame(then.toFrame(item.position()));
    }

    private static int index(double seconds) {
        return Math.floorMod(PortableMath.round(seconds / Cycle.SECONDS), MEMORY_CYCLES);
    }

    private static Posture posture(Robot nao) {
        return Posture.of(Arrays.stream(JOINTS).mapToDouble(nao::getJointAngle).toArray());
    }

    private static double load(Robot nao, Leg leg) {
        return nao.getFootPressure(leg).map(pressure -> pressure.force().z()).orElse(0.0);
    }

    /** Returns the pose of the torso in the frame of a foot that is flat on the ground. */
    private static Pose2d torsoOn(BodyPoses body, Leg leg) {
        Pose torso = body.foot(leg).inverse();
        Vector3 forward = torso.rotation().apply(new Vector3(1, 0, 0));
        return new Pose2d(torso.position().x(), torso.position().y(), BodyState.headingDegrees(forward));
    }
}

package org.robonewbie.nao.kinematics;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.Hinge;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Posture;

/**
 * Forward kinematics: the pose of each link, calculated from the joint angles. From the torso outwards, each hinge rotates its
 * child link about the hinge's axis.
 *
 * <pre>{@code
 * BodyPoses body = ForwardKinematics.of(RobotType.TYPE_0).poses(posture);
 * Vector3 leftFoot = body.foot(Leg.LEFT).position();   // relative to the torso's centre, in metres
 * }</pre>
 */
public final class ForwardKinematics {

    private static final List<ForwardKinematics> ALL =
            Arrays.stream(RobotType.values()).map(ForwardKinematics::new).toList();
    private static final Joint[] JOINTS = Joint.values();

    private final NaoModel model;
    private final List<Turn> turns = new ArrayList<>();

    /** One hinge: its child moves with its parent and rotates about the axis, given in coordinates of the construction pose. */
    private record Turn(int parent, int child, Vector3 anchor, Vector3 axis) {}

    private ForwardKinematics(RobotType type) {
        model = NaoModel.of(type);
        for (Hinge hinge : model.hinges()) {
            turns.add(new Turn(
                    model.linkIndex(hinge.parent()),
                    model.linkIndex(hinge.child()),
                    SimSparkFrame.toBody(hinge.anchor()),
                    SimSparkFrame.toBody(hinge.axis())));
        }
    }

    /**
     * Returns the kinematics of a robot type.
     *
     * @param type the robot type
     * @return its kinematics
     */
    public static ForwardKinematics of(RobotType type) {
        return ALL.get(type.ordinal());
    }

    /**
     * Calculates the poses of all links. The toes of robot type 4 are assumed to be straight.
     *
     * @param posture the joint angles
     * @return the poses of all links
     */
    public BodyPoses poses(Posture posture) {
        return poses(hingeDegrees(posture));
    }

    /** Calculates the poses of all links for angles in the order of the model's hinges. */
    BodyPoses poses(double[] hingeDegrees) {
        // Each entry maps a point of the construction pose to its current position.
        Pose[] moved = new Pose[model.links().size()];
        moved[0] = Pose.ORIGIN;
        for (int i = 0; i < hingeDegrees.length; i++) {
            Turn turn = turns.get(i);
            moved[turn.child] = moved[turn.parent].times(turned(turn, hingeDegrees[i]));
        }
        List<Pose> poses = new ArrayList<>(moved.length);
        for (int i = 0; i < moved.length; i++) {
            poses.add(new Pose(moved[i].transform(constructionPosition(i)), moved[i].rotation()));
        }
        return new BodyPoses(model, poses);
    }

    /** Returns the angles of a posture in the order of the model's hinges, with straight toes. */
    double[] hingeDegrees(Posture posture) {
        double[] degrees = new double[model.hinges().size()];
        for (Joint joint : JOINTS) {
            degrees[model.hingeIndex(joint)] = posture.degrees(joint);
        }
        return degrees;
    }

    /**
     * Calculates the pose of the camera, which is at the centre of the head and looks along the head's x axis.
     *
     * @param neckYawDegrees angle of {@link Joint#NECK_YAW} in degrees
     * @param neckPitchDegrees angle of {@link Joint#NECK_PITCH} in degrees
     * @return the camera's pose relative to the torso
     */
    public Pose camera(double neckYawDegrees, double neckPitchDegrees) {
        Pose yaw = turned(turns.get(model.hingeIndex(Joint.NECK_YAW)), neckYawDegrees);
        Pose pitch = turned(turns.get(model.hingeIndex(Joint.NECK_PITCH)), neckPitchDegrees);
        Pose moved = yaw.times(pitch);
        return new Pose(moved.transform(constructionPosition(model.linkIndex(BodyPoses.HEAD))), moved.rotation());
    }

    private static Pose turned(Turn turn, double degrees) {
        Rotation rotation = Rotation.about(turn.axis, degrees);
        return new Pose(turn.anchor.minus(rotation.apply(turn.anchor)), rotation);
    }

    private Vector3 constructionPosition(int link) {
        return SimSparkFrame.toBody(model.links().get(link).position());
    }
}

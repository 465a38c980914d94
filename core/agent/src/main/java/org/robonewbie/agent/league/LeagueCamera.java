package org.robonewbie.agent.league;

import java.util.List;
import org.robonewbie.agent.cycle.CameraKinematics;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.robot.BoosterT1;
import org.robonewbie.robot.RobotModel;

/** The camera of a league robot: the site {@code camera} in its {@code robot.xml}. */
final class LeagueCamera implements CameraKinematics {

    private final RobotModel model;
    private final List<SharedJoint> shared;
    private final int head;
    private final Pose inHead;

    LeagueCamera(RobotModel model, List<SharedJoint> shared) {
        this.model = model;
        this.shared = shared;
        boolean isT1 = model.equals(BoosterT1.MODEL);
        this.head = model.bodyIndex(isT1 ? "H2" : "Head_2");
        this.inHead = new Pose(isT1 ? new Vector3(0.05, 0, 0.12) : new Vector3(0.06, 0, 0.08), Rotation.NONE);
    }

    @Override
    public Pose pose(double neckYawDegrees, double neckPitchDegrees) {
        double[] degrees = new double[model.joints().size()];
        for (SharedJoint joint : shared) {
            if (!joint.isArm()) {
                degrees[joint.index()] =
                        joint.fromNao(joint.joint() == Joint.NECK_YAW ? neckYawDegrees : neckPitchDegrees);
            }
        }
        return model.bodyPoses(degrees).get(head).times(inHead);
    }
}

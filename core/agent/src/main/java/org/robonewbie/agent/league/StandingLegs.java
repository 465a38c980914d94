package org.robonewbie.agent.league;

import java.util.List;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.robot.RobotBody;
import org.robonewbie.robot.RobotJoint;
import org.robonewbie.robot.RobotModel;

/**
 * Legs that stand. They hold the stance, and lean the robot back as far as its arms shift its centre of mass forward: arms that point
 * forward would make it fall.
 */
final class StandingLegs {

    private final RobotModel model;
    private final double[] stance;
    private final List<RobotJoint> ankles;
    private final double forwardInStance;

    StandingLegs(RobotModel model) {
        this.model = model;
        this.stance = model.stanceDegrees();
        this.ankles = model.joints().stream()
                .filter(joint -> joint.name().endsWith("_Ankle_Pitch"))
                .toList();
        this.forwardInStance = forward(stance);
    }

    /**
     * Returns the angles of a standing robot.
     *
     * @param upperBody joints that may have any angle: those of arms and head
     * @param degrees the angles of all joints, of which only those of the upper body are used
     * @return the same angles of the upper body, and those of legs and waist
     */
    double[] stand(List<SharedJoint> upperBody, double[] degrees) {
        double[] standing = stance.clone();
        upperBody.forEach(joint -> standing[joint.index()] = degrees[joint.index()]);
        double ahead = forward(standing) - forwardInStance;
        double lean = PortableMath.toDegrees(PortableMath.atan2(ahead, model.stanceHeight()));
        ankles.forEach(ankle -> standing[ankle.index()] += lean);
        return standing;
    }

    /** Returns how far ahead of the torso's frame the centre of mass is, in metres. */
    private double forward(double[] degrees) {
        List<Pose> poses = model.bodyPoses(degrees);
        double moment = 0;
        for (int i = 0; i < poses.size(); i++) {
            RobotBody body = model.bodies().get(i);
            moment += body.massKg()
                    * poses.get(i).times(body.inertialPose()).position().x();
        }
        return moment / model.massKg();
    }
}

package org.robonewbie.learning.environment;

import java.util.List;
import java.util.stream.Stream;
import org.robonewbie.nao.BodyPart;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.kinematics.ForwardKinematics;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;

/** Task: move the left lower arm to a random point in front of and beside the left shoulder. */
final class ReachTraining extends TrainingTask {

    private static final List<Joint> ARM =
            List.of(Joint.LEFT_SHOULDER_PITCH, Joint.LEFT_SHOULDER_YAW, Joint.LEFT_ARM_ROLL, Joint.LEFT_ARM_YAW);
    private static final Vector3 SHOULDER = new Vector3(0, 0.098, 0.075);
    private static final double REACH_METRES = 0.15;
    private static final double NEAR_METRES = 0.03;

    private Vector3 target = Vector3.ZERO;
    private Vector3 arm = Vector3.ZERO;
    private double totalReward;

    @Override
    public void begin(Trial trial) {
        double elevation = PortableMath.toRadians(random().between(-60, 60));
        Vector3 fromShoulder = new Pose2d(0, 0, random().between(-22.5, 67.5))
                .point(REACH_METRES * PortableMath.cos(elevation), 0, REACH_METRES * PortableMath.sin(elevation));
        target = SHOULDER.plus(fromShoulder);
    }

    @Override
    public List<Joint> joints() {
        return ARM;
    }

    @Override
    public double rangeDegrees() {
        return 120;
    }

    @Override
    public int longestCycles() {
        return 100;
    }

    @Override
    public List<ObservedQuantity> extraQuantities() {
        return Stream.of("target", "arm")
                .flatMap(thing -> ObservedQuantity.vector(thing, "m", 0.5).stream())
                .toList();
    }

    @Override
    public double[] extras() {
        return new double[] {target.x(), target.y(), target.z(), arm.x(), arm.y(), arm.z()};
    }

    @Override
    protected void see(WorldState first, WorldState now) {
        BodyState robot = now.robot();
        arm = ForwardKinematics.of(robot.type())
                .poses(robot.joints())
                .link(BodyPart.LEFT_LOWER_ARM.simSparkName())
                .position();
        totalReward -= arm.distanceTo(target);
    }

    /** {@return whether the arm is within 3 cm of the target} */
    @Override
    public boolean isDone() {
        return arm.distanceTo(target) <= NEAR_METRES;
    }

    @Override
    public String rewardRule() {
        return "per cycle, minus the distance in metres between the left lower arm and its target";
    }

    @Override
    public String successRule() {
        return "within 3 cm";
    }

    @Override
    public double value() {
        return totalReward;
    }
}

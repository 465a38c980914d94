package org.robonewbie.simulator.recording;

import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.robot.RobotModel;
import org.robonewbie.robot.RobotState;
import org.robonewbie.simulator.world.Robot;

/**
 * Ground-truth results for one robot: its falls and the distance that it walked.
 *
 * <p>A NAO is standing while its torso is tilted by less than 30 degrees and the centre of the torso is more than 0.25 m above
 * the ground. A fall is counted when the torso of a robot that has stood since its last fall tilts by more than 60 degrees or
 * sinks below 0.2 m. For other robots, the heights are those of {@link org.robonewbie.robot.RobotState}.
 *
 * <p>The distance walked is the length of the upright torso's path over the ground, low-pass filtered with a time constant of
 * 0.5 s and measured in segments of 0.1 m, so that swaying on the spot does not count. Beams and moves by the referee do not
 * count either.
 */
final class RobotStatistics {

    private static final double SMOOTHING = Cycle.SECONDS / 0.5;
    private static final double SEGMENT_METRES = 0.1;

    /** Movement per cycle above which the robot must have been beamed. */
    private static final double BEAM_METRES = 0.1;

    private final RobotModel model;
    private Vector3 start = Vector3.ZERO;
    private Vector3 position = Vector3.ZERO;
    private double headingDegrees;
    private double leanDegrees;
    private final double[] jointDegrees;
    private double smoothX;
    private double smoothY;
    private double milestoneX;
    private double milestoneY;
    private double walkedX;
    private double walkedY;
    private double metresWalked;
    private boolean hasStood;
    private int falls;

    RobotStatistics(RobotModel model) {
        this.model = model;
        this.jointDegrees = new double[model.joints().size()];
    }

    void beforeStep(Robot robot) {
        start = robot.linkPosition(0);
    }

    void afterStep(Robot robot) {
        position = robot.linkPosition(0);
        leanDegrees = robot.tiltDegrees();
        countFalls();
        double x = position.x() - start.x();
        double y = position.y() - start.y();
        if (leanDegrees < BodyState.FALLEN_DEGREES && PortableMath.hypot(x, y) < BEAM_METRES) {
            walk(x, y);
        }
    }

    /** Updates the final state after the referee has acted. */
    void cycleEnded(Robot robot) {
        position = robot.linkPosition(0);
        leanDegrees = robot.tiltDegrees();
        headingDegrees = robot.headingDegrees();
        for (int i = 0; i < jointDegrees.length; i++) {
            jointDegrees[i] = robot.jointDegrees(i);
        }
    }

    RobotModel model() {
        return model;
    }

    double[] jointDegrees() {
        return jointDegrees;
    }

    int falls() {
        return falls;
    }

    double metresWalked() {
        return metresWalked;
    }

    Vector3 position() {
        return position;
    }

    double headingDegrees() {
        return headingDegrees;
    }

    boolean isUpright() {
        return RobotState.isStanding(model, leanDegrees, position.z());
    }

    private void countFalls() {
        if (isUpright()) {
            hasStood = true;
        } else if (hasStood && RobotState.isFallen(model, leanDegrees, position.z())) {
            hasStood = false;
            falls++;
        }
    }

    /** Adds a movement to the path walked, unless it is a jump. */
    private void walk(double x, double y) {
        walkedX += x;
        walkedY += y;
        smoothX += SMOOTHING * (walkedX - smoothX);
        smoothY += SMOOTHING * (walkedY - smoothY);
        double length = PortableMath.hypot(smoothX - milestoneX, smoothY - milestoneY);
        if (length >= SEGMENT_METRES) {
            metresWalked += length;
            milestoneX = smoothX;
            milestoneY = smoothY;
        }
    }
}

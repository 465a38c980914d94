package org.robonewbie.simulator.recording;

import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.simulator.world.Robot;

/**
 * What one robot has really done: its falls and the way that it walked.
 *
 * <p>A robot stands while its torso leans by less than 30 degrees and its centre is more than 0.25 m above the ground. It has
 * fallen when after standing its torso leans by more than 60 degrees or sinks below 0.2 m; it can fall again only after standing
 * again.
 *
 * <p>The walked way is that of the torso over the ground while it is upright, smoothed with a time constant of half a
 * second and measured in pieces of 0.1 m, so that swaying on the spot is no walking. Whoever is beamed, or carried by the
 * referee, does not walk.
 */
final class RobotStatistics {

    private static final double SMOOTHING = Cycle.SECONDS / 0.5;
    private static final double PIECE = 0.1;

    /** No robot walks so far within one cycle. */
    private static final double BEAMED_WAY = 0.1;

    private final NaoModel model;
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

    RobotStatistics(NaoModel model) {
        this.model = model;
        this.jointDegrees = new double[model.hinges().size()];
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
        if (leanDegrees < BodyState.FALLEN_DEGREES && PortableMath.hypot(x, y) < BEAMED_WAY) {
            walk(x, y);
        }
    }

    /** Looks at the robot after the referee has had his turn. */
    void cycleEnded(Robot robot) {
        position = robot.linkPosition(0);
        leanDegrees = robot.tiltDegrees();
        headingDegrees = robot.headingDegrees();
        for (int i = 0; i < jointDegrees.length; i++) {
            jointDegrees[i] = robot.jointDegrees(i);
        }
    }

    NaoModel model() {
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

    /** Where the robot looks, 0 along the world's x axis, counter-clockwise. */
    double headingDegrees() {
        return headingDegrees;
    }

    boolean isUpright() {
        return BodyState.isStanding(leanDegrees, position.z());
    }

    private void countFalls() {
        if (isUpright()) {
            hasStood = true;
        } else if (hasStood && BodyState.isFallen(leanDegrees, position.z())) {
            hasStood = false;
            falls++;
        }
    }

    /** Adds a piece of way; positions are counted from the robot's first place without jumps. */
    private void walk(double x, double y) {
        walkedX += x;
        walkedY += y;
        smoothX += SMOOTHING * (walkedX - smoothX);
        smoothY += SMOOTHING * (walkedY - smoothY);
        double length = PortableMath.hypot(smoothX - milestoneX, smoothY - milestoneY);
        if (length >= PIECE) {
            metresWalked += length;
            milestoneX = smoothX;
            milestoneY = smoothY;
        }
    }
}

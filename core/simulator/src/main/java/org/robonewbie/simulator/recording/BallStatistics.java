package org.robonewbie.simulator.recording;

import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;

/**
 * Ground-truth results for the ball: the distance that it rolled and flew, excluding moves by the referee, and the
 * minimum distance of its centre from the mouth of the goal that the left team attacks, 0 once it is in the goal.
 */
final class BallStatistics {

    /** Movements below 5 mm/s are jitter. */
    private static final double MIN_STEP_METRES = 1e-4;

    private final SoccerField field;
    private Vector3 start = Vector3.ZERO;
    private Vector3 position = Vector3.ZERO;
    private double metresMoved;
    private double leastDistanceToGoal = Double.POSITIVE_INFINITY;

    BallStatistics(SoccerField field) {
        this.field = field;
    }

    void beforeStep(Vector3 ball) {
        start = ball;
    }

    void afterStep(Vector3 ball) {
        position = ball;
        double step = PortableMath.hypot(ball.x() - start.x(), ball.y() - start.y());
        if (step >= MIN_STEP_METRES) {
            metresMoved += step;
        }
        leastDistanceToGoal = Math.min(leastDistanceToGoal, distanceToGoal(ball));
    }

    void cycleEnded(Vector3 ball) {
        position = ball;
    }

    Vector3 position() {
        return position;
    }

    double metresMoved() {
        return metresMoved;
    }

    double leastDistanceToGoal() {
        return leastDistanceToGoal;
    }

    private double distanceToGoal(Vector3 ball) {
        double ahead = Math.max(0, field.length() / 2 - ball.x());
        double aside = Math.max(0, Math.abs(ball.y()) - field.goalWidth() / 2);
        return PortableMath.hypot(ahead, aside);
    }
}

package org.robonewbie.simulator.recording;

import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;

/**
 * What the ball has really done: the way that it rolled and flew over the ground, without being placed by the referee, and
 * how near its centre came to the mouth of the goal that the left team attacks (0 once it is in).
 */
final class BallStatistics {

    /** Slower than 5 mm/s is trembling, not moving. */
    private static final double MIN_WAY = 1e-4;

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
        double way = PortableMath.hypot(ball.x() - start.x(), ball.y() - start.y());
        if (way >= MIN_WAY) {
            metresMoved += way;
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

package org.robonewbie.agent.localisation;

import org.robonewbie.agent.perception.Direction;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.math.PortableMath;

/**
 * The belief of where the torso is, in six dimensions: place, height and heading, and how it leans and rolls. It is an extended
 * Kalman filter (S. Thrun, W. Burgard, D. Fox, <em>Probabilistic Robotics</em>, 2005, chapters 3 and 7). A movement makes the
 * belief less certain. A landmark makes it more certain: the difference between where the camera should see it and where it does
 * is shared out among all dimensions, more to those that are less certain.
 */
final class PoseFilter {

    private static final int X = 0;
    private static final int Y = 1;
    private static final int HEADING = 2;
    private static final int HEIGHT = 3;
    private static final int LEAN = 4;
    private static final int ROLL = 5;
    private static final int DIMENSIONS = 6;

    private static final double USUAL_HEIGHT = 0.36;
    private static final double FIRST_METRES = 0.05;
    private static final double FIRST_DEGREES = 5;
    private static final double CARRIED_METRES = 0.5;
    private static final double CARRIED_DEGREES = 15;
    private static final double LYING_METRES = 0.04;
    private static final double LYING_DEGREES = 2;
    private static final double NUDGE = 1e-4;
    /** What is seen further beside its place than this many standard deviations is taken for a mistake. */
    private static final double MOST_DEVIATIONS = 5;

    private static final double ANGLE_DEVIATION = 0.5;
    private static final double DISTANCE_DEVIATION = 0.02;
    private static final double DISTANCE_DEVIATION_PER_METRE = 0.003;
    private static final double SLIP = 0.4;
    private static final double LEAST_METRES = 0.0005;
    private static final double LEAST_DEGREES = 0.03;
    private static final double TURN_SHARE = 0.02;
    private static final double TILT_DEGREES = 0.3;
    private static final double HEIGHT_METRES = 0.002;
    private static final double GRAVITY_DEVIATION = 25;
    private static final double HEIGHT_DEVIATION = 0.03;

    private final double[] state = new double[DIMENSIONS];
    private final double[][] covariance = new double[DIMENSIONS][DIMENSIONS];

    /** Begins again at a pose. */
    void begin(GroundPose pose, double deviationMetres, double deviationDegrees) {
        forget(X, pose.x(), deviationMetres);
        forget(Y, pose.y(), deviationMetres);
        forget(HEADING, pose.headingDegrees(), deviationDegrees);
        standUpright();
    }

    /**
     * Moves on.
     *
     * @param forward metres
     * @param left metres
     * @param degrees how far the torso has turned to the left, bowed forward and rolled to the right, as z, y, x
     */
    void move(double forward, double left, Vector3 degrees) {
        GroundPose moved = pose().moved(forward, left, degrees.z());
        double radians = PortableMath.toRadians(1);
        addToRow(X, HEADING, -radians * (moved.y() - state[Y]));
        addToRow(Y, HEADING, radians * (moved.x() - state[X]));
        state[X] = moved.x();
        state[Y] = moved.y();
        state[HEADING] = moved.headingDegrees();
        state[LEAN] += degrees.y();
        state[ROLL] += degrees.x();
        double metres = LEAST_METRES + SLIP * PortableMath.hypot(forward, left);
        doubt(X, metres);
        doubt(Y, metres);
        doubt(HEADING, LEAST_DEGREES + TURN_SHARE * Math.abs(degrees.z()));
        doubt(HEIGHT, HEIGHT_METRES);
        doubt(LEAN, TILT_DEGREES);
        doubt(ROLL, TILT_DEGREES);
    }

    /** Lies on the ground: when it is up again the torso is level, and the place is less certain with each cycle. */
    void lie() {
        doubt(X, LYING_METRES);
        doubt(Y, LYING_METRES);
        doubt(HEADING, LYING_DEGREES);
        standUpright();
    }

    /** Feels where gravity pulls; shocks of the feet make that rough. */
    void feel(double leanDegrees, double rollDegrees) {
        correct(LEAN, leanDegrees - state[LEAN], GRAVITY_DEVIATION);
        correct(ROLL, rollDegrees - state[ROLL], GRAVITY_DEVIATION);
    }

    /** Knows the height of the torso above the standing foot. */
    void stand(double height) {
        correct(HEIGHT, height - state[HEIGHT], HEIGHT_DEVIATION);
    }

    /**
     * Sees a landmark.
     *
     * @param map where it stands
     * @param seen where the camera sees it
     * @param camera the camera in the torso's frame
     * @return whether it is where it is expected; if not, it is not believed
     */
    boolean see(Vector3 map, Direction seen, Pose camera) {
        Pose eye = camera.inverse();
        Direction expected = expected(map, eye);
        double[][] gradients = new double[3][DIMENSIONS];
        for (int i = 0; i < DIMENSIONS; i++) {
            double before = state[i];
            state[i] += NUDGE;
            Direction nudged = expected(map, eye);
            state[i] = before;
            gradients[0][i] = (nudged.distance() - expected.distance()) / NUDGE;
            gradients[1][i] = difference(nudged.bearing(), expected.bearing()) / NUDGE;
            gradients[2][i] = (nudged.elevation() - expected.elevation()) / NUDGE;
        }
        double[] start = state.clone();
        double near = DISTANCE_DEVIATION + DISTANCE_DEVIATION_PER_METRE * seen.distance();
        double aside = difference(seen.bearing(), expected.bearing());
        return correct(gradients[0], seen.distance() - expected.distance(), near, start)
                && correct(gradients[1], aside, ANGLE_DEVIATION, start)
                && correct(gradients[2], seen.elevation() - expected.elevation(), ANGLE_DEVIATION, start);
    }

    /** Doubts place and heading, since what is seen again and again contradicts them. */
    void doubt() {
        doubt(X, CARRIED_METRES);
        doubt(Y, CARRIED_METRES);
        doubt(HEADING, CARRIED_DEGREES);
    }

    /** Where the camera should see a point of the pitch. */
    private Direction expected(Vector3 map, Pose eye) {
        Pose torso = new Pose(
                new Vector3(state[X], state[Y], state[HEIGHT]),
                Rotation.ofYawPitchRoll(state[HEADING], state[LEAN], state[ROLL]));
        return Direction.of(eye.transform(torso.inverse().transform(map)));
    }

    GroundPose pose() {
        return new GroundPose(state[X], state[Y], PortableMath.IEEEremainder(state[HEADING], 360));
    }

    double height() {
        return state[HEIGHT];
    }

    double leanDegrees() {
        return state[LEAN];
    }

    double rollDegrees() {
        return state[ROLL];
    }

    private void standUpright() {
        forget(HEIGHT, USUAL_HEIGHT, FIRST_METRES);
        forget(LEAN, 0, FIRST_DEGREES);
        forget(ROLL, 0, FIRST_DEGREES);
    }

    /** Takes a new value for a dimension that has nothing to do with what was before. */
    private void forget(int dimension, double value, double deviation) {
        for (int i = 0; i < DIMENSIONS; i++) {
            covariance[dimension][i] = 0;
            covariance[i][dimension] = 0;
        }
        state[dimension] = value;
        doubt(dimension, deviation);
    }

    private void doubt(int dimension, double deviation) {
        covariance[dimension][dimension] += deviation * deviation;
    }

    /** Follows a change of coordinates in which one dimension gets a share of another. */
    private void addToRow(int to, int from, double share) {
        for (int i = 0; i < DIMENSIONS; i++) {
            covariance[to][i] += share * covariance[from][i];
        }
        for (int i = 0; i < DIMENSIONS; i++) {
            covariance[i][to] += share * covariance[i][from];
        }
    }

    private void correct(int dimension, double difference, double deviation) {
        double[] gradient = new double[DIMENSIONS];
        gradient[dimension] = 1;
        correct(gradient, difference, deviation, state.clone());
    }

    /** Learns from one number: by how much it differs from what was expected at the start, and how sure it is. */
    private boolean correct(double[] gradient, double difference, double deviation, double[] start) {
        double missing = difference;
        double[] shares = new double[DIMENSIONS];
        double variance = deviation * deviation;
        for (int i = 0; i < DIMENSIONS; i++) {
            missing -= gradient[i] * (state[i] - start[i]);
            for (int j = 0; j < DIMENSIONS; j++) {
                shares[i] += covariance[i][j] * gradient[j];
            }
            variance += gradient[i] * shares[i];
        }
        if (missing * missing > MOST_DEVIATIONS * MOST_DEVIATIONS * variance) {
            return false;
        }
        for (int i = 0; i < DIMENSIONS; i++) {
            state[i] += shares[i] / variance * missing;
            for (int j = 0; j < DIMENSIONS; j++) {
                covariance[i][j] -= shares[i] * shares[j] / variance;
            }
        }
        return true;
    }

    private static double difference(double one, double other) {
        return PortableMath.IEEEremainder(one - other, 360);
    }
}

package org.robonewbie.agent.localisation;

import java.util.Optional;
import org.robonewbie.agent.perception.Direction;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.math.PortableMath;

/**
 * Error-state Kalman filter for position, attitude and velocity of the torso. The gyroscope and the accelerometer
 * predict the state by inertial navigation, even while the robot is falling, lying on the ground or getting up;
 * landmarks and the support foot correct the drift.
 *
 * <p>The error state contains a small rotation vector instead of angles, so there is no singular attitude (J. Solà,
 * <em>Quaternion kinematics for the error-state Kalman filter</em>, 2017).
 */
final class ErrorStateKalmanFilter {

    /**
     * Indices of the first components of position, velocity and rotation in the covariance. Each has three components,
     * along or about the axes of the field, in metres, metres per second and radians.
     */
    private static final int PLACE = 0;

    private static final int VELOCITY = 3;
    private static final int TURN = 6;
    private static final int DIMENSIONS = 9;

    private static final double DEFAULT_HEIGHT = 0.36;
    private static final double FIRST_HEIGHT = 0.1;
    private static final double FIRST_TILT = PortableMath.toRadians(5);
    private static final double FIRST_SPEED = 0.5;
    private static final double GRAVITY = 9.81;
    /** Plausibility limit in m/s²; higher readings occur when the robot is beamed or moved by hand. */
    private static final double MAX_ACCELERATION = 300;

    private static final double MAX_DEVIATIONS = 5;

    private static final double PLACE_DEVIATION = 0.001;
    private static final double VELOCITY_DEVIATION = 0.003;
    private static final double TURN_DEVIATION = PortableMath.toRadians(0.01);
    private static final double SIGHT_DEVIATION = 0.006;
    private static final double DISTANCE_DEVIATION_PER_METRE = 0.0015;
    private static final double ASIDE_DEVIATION_PER_METRE = PortableMath.toRadians(0.25);
    private static final double FOOT_DEVIATION = 0.5;
    private static final double HEIGHT_DEVIATION = 0.2;

    private final KalmanCovariance covariance = new KalmanCovariance(DIMENSIONS);
    private Vector3 place = new Vector3(0, 0, DEFAULT_HEIGHT);
    private Vector3 velocity = Vector3.ZERO;
    private Rotation attitude = Rotation.NONE;

    /** Creates a filter for an upright robot on the centre spot. */
    ErrorStateKalmanFilter() {
        begin(Pose2d.ORIGIN, 0, 0);
    }

    /** Restarts with an upright robot at rest. */
    void begin(Pose2d pose, double deviationMetres, double deviationDegrees) {
        place = new Vector3(pose.x(), pose.y(), DEFAULT_HEIGHT);
        velocity = Vector3.ZERO;
        attitude = Rotation.about(new Vector3(0, 0, 1), pose.degrees());
        double[] deviations = {
            deviationMetres, deviationMetres, FIRST_HEIGHT,
            FIRST_SPEED, FIRST_SPEED, FIRST_SPEED,
            FIRST_TILT, FIRST_TILT, PortableMath.toRadians(deviationDegrees)
        };
        for (int i = 0; i < DIMENSIONS; i++) {
            covariance.reset(i, deviations[i]);
        }
    }

    /**
     * Predicts one cycle. The accelerometer's reading is one cycle old, so it belongs to the attitude before the rotation.
     *
     * @param gyro angular velocity in degrees per second about the axes of the torso
     * @param specificForce specific force in m/s² along the axes of the torso
     */
    void move(Vector3 gyro, Vector3 specificForce) {
        if (specificForce.length() < MAX_ACCELERATION) {
            accelerate(attitude.apply(specificForce));
        } else {
            resetVelocity();
        }
        place = place.plus(velocity.times(Cycle.SECONDS));
        attitude = attitude.times(rotation(gyro.times(Cycle.SECONDS)));
        for (int i = 0; i < 3; i++) {
            covariance.propagate(PLACE + i, VELOCITY + i, Cycle.SECONDS);
            covariance.addProcessNoise(PLACE + i, PLACE_DEVIATION);
            covariance.addProcessNoise(VELOCITY + i, VELOCITY_DEVIATION);
            covariance.addProcessNoise(TURN + i, TURN_DEVIATION);
        }
    }

    /** Couples velocity and attitude: an attitude error rotates the specific force, which makes the tilt observable. */
    private void accelerate(Vector3 specificForce) {
        velocity = velocity.plus(specificForce.minus(new Vector3(0, 0, GRAVITY)).times(Cycle.SECONDS));
        double[] push = components(specificForce.times(Cycle.SECONDS));
        for (int i = 0; i < 3; i++) {
            int next = (i + 1) % 3;
            int last = (i + 2) % 3;
            covariance.propagate(VELOCITY + i, TURN + next, push[last]);
            covariance.propagate(VELOCITY + i, TURN + last, -push[next]);
        }
    }

    /** Resets the velocity after a shock. */
    private void resetVelocity() {
        velocity = Vector3.ZERO;
        for (int i = 0; i < 3; i++) {
            covariance.reset(VELOCITY + i, FIRST_SPEED);
        }
    }

    /** Increases the uncertainty after missed cycles. */
    void miss(double seconds) {
        for (int i = 0; i < 3; i++) {
            covariance.addProcessNoise(PLACE + i, FIRST_SPEED * seconds);
            covariance.addProcessNoise(VELOCITY + i, FIRST_SPEED);
            covariance.addProcessNoise(TURN + i, PortableMath.toRadians(90) * seconds);
        }
    }

    /**
     * Corrects velocity and height using the kinematics of the support leg. Feet slip, so the deviations are large.
     *
     * @param forward forward velocity in metres per second
     * @param left velocity to the left in metres per second
     * @param height height of the torso's centre above the sole, in metres
     */
    void stand(double forward, double left, double height) {
        Vector3 expected = new Pose2d(0, 0, pose().degrees()).toFrame(new Vector3(forward, left, 0));
        correct(VELOCITY, expected.x() - velocity.x(), FOOT_DEVIATION);
        correct(VELOCITY + 1, expected.y() - velocity.y(), FOOT_DEVIATION);
        correct(PLACE + 2, height - place.z(), HEIGHT_DEVIATION);
    }

    private void correct(int dimension, double innovation, double deviation) {
        double[] gradient = new double[DIMENSIONS];
        gradient[dimension] = 1;
        covariance.correct(gradient, innovation, deviation, MAX_DEVIATIONS).ifPresent(this::apply);
    }

    /**
     * Corrects the state using a sighting of a landmark. The innovation is measured in metres at the landmark, along
     * the line of sight and in both directions perpendicular to it.
     *
     * @param map position of the landmark on the map
     * @param seen direction in the camera's frame
     * @param camera pose of the camera in the torso's frame
     * @return whether the measurement was plausible enough to be used
     */
    boolean see(Vector3 map, Direction seen, Pose camera) {
        double across = SIGHT_DEVIATION + ASIDE_DEVIATION_PER_METRE * seen.distance();
        double along = SIGHT_DEVIATION + DISTANCE_DEVIATION_PER_METRE * seen.distance();
        Vector3 left = new Direction(1, seen.bearing() + 90, 0).toPoint();
        Vector3 up = new Direction(1, seen.bearing(), seen.elevation() + 90).toPoint();
        return see(map, seen, camera, left, across)
                && see(map, seen, camera, up, across)
                && see(map, seen, camera, seen.toPoint().times(1 / seen.distance()), along);
    }

    private boolean see(Vector3 map, Direction seen, Pose camera, Vector3 axis, double deviation) {
        Vector3 here = attitude.apply(camera.transform(seen.toPoint()));
        Vector3 direction = attitude.apply(camera.rotation().apply(axis));
        double[] moved = components(direction);
        double[] turned = components(here.cross(direction));
        double[] gradient = new double[DIMENSIONS];
        for (int i = 0; i < 3; i++) {
            gradient[PLACE + i] = moved[i];
            gradient[TURN + i] = turned[i];
        }
        double innovation = map.minus(place.plus(here)).dot(direction);
        Optional<double[]> corrections = covariance.correct(gradient, innovation, deviation, MAX_DEVIATIONS);
        corrections.ifPresent(this::apply);
        return corrections.isPresent();
    }

    private void apply(double[] corrections) {
        place = place.plus(vector(corrections, PLACE));
        velocity = velocity.plus(vector(corrections, VELOCITY));
        attitude = rotation(vector(corrections, TURN).times(PortableMath.toDegrees(1)))
                .times(attitude);
    }

    /** Returns the pose of the torso on the field. */
    Pose2d pose() {
        return new Pose2d(place.x(), place.y(), attitude.yawDegrees());
    }

    /** Returns the pose of the torso in space. */
    Pose torso() {
        return new Pose(place, attitude);
    }

    /** Converts a rotation vector in degrees to a rotation. */
    private static Rotation rotation(Vector3 degrees) {
        double size = degrees.length();
        return size == 0 ? Rotation.NONE : Rotation.about(degrees, size);
    }

    private static double[] components(Vector3 vector) {
        return new double[] {vector.x(), vector.y(), vector.z()};
    }

    private static Vector3 vector(double[] numbers, int first) {
        return new Vector3(numbers[first], numbers[first + 1], numbers[first + 2]);
    }
}

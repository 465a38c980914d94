package org.robonewbie.agent.localisation;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.robonewbie.agent.Robot;
import org.robonewbie.agent.perception.CameraPicture;
import org.robonewbie.agent.perception.Direction;
import org.robonewbie.agent.perception.LocalFieldView;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.FieldMarking;
import org.robonewbie.nao.Landmark;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.math.PortableMath;

/**
 * Estimates the robot's pose on the field with a Kalman filter: the gyroscope, the accelerometer and {@link Odometry}
 * predict it, and each visible landmark corrects it, along with the estimated height and tilt of the torso. The first
 * pose requires two landmarks in one picture; it is the best rigid fit of the sightings to the map.
 *
 * <p>It also identifies the field: the known fields differ in the distances between their goal posts and flags. On the field of
 * today's league it uses the {@linkplain FieldMarking points of the field lines} as well.
 *
 * <p>Coordinates are those of the robot's team: x towards the opponents' goal, y to the left, the origin at the centre
 * of the field.
 *
 * <pre>{@code
 * private final SelfLocalisation self = new SelfLocalisation();
 * // at the beginning of think():
 * self.update(nao, fieldView);
 * nao.publishPose(self.pose().x(), self.pose().y(), self.pose().headingDegrees());   // for the studio
 * }</pre>
 */
public final class SelfLocalisation {

    private static final double FIT_METRES = 1;
    private static final double FIT_DEGREES = 10;
    private static final double SET_METRES = 0.3;
    private static final double SET_DEGREES = 0.5;
    private static final int PICTURES_TO_DOUBT = 4;
    private static final double STANDING_DEGREES = 20;
    private static final double MAX_MISSED_SECONDS = 10;

    private static final Set<String> LANDMARKS =
            Arrays.stream(Landmark.values()).map(Landmark::name).collect(Collectors.toSet());
    private static final Map<String, Vector3> MARKINGS =
            Arrays.stream(FieldMarking.values()).collect(Collectors.toMap(FieldMarking::name, FieldMarking::position));
    private static final List<SoccerField> PITCHES =
            List.of(SoccerField.BEGINNER, SoccerField.LEAGUE, SoccerField.SEVEN);
    private static final double CERTAIN_METRES = 0.3;

    private SoccerField field;
    private boolean fieldKnown;
    private final Odometry odometry = new Odometry();
    private final ErrorStateKalmanFilter filter = new ErrorStateKalmanFilter();
    private int contradictions;
    private boolean known;
    private double seenSeconds = Double.NEGATIVE_INFINITY;
    private double nowSeconds = Double.NaN;

    /** Sighting of a landmark: direction in the camera's frame, position in the torso's frame, and position on the map. */
    private record Sighting(Direction direction, Vector3 seen, Vector3 map) {}

    /** Creates an instance with unknown pose and unknown field. */
    public SelfLocalisation() {
        this(SoccerField.BEGINNER, false);
    }

    /**
     * Creates an instance with unknown pose on a known field.
     *
     * @param field the field with its landmarks
     */
    public SelfLocalisation(SoccerField field) {
        this(field, true);
    }

    private SelfLocalisation(SoccerField field, boolean fieldKnown) {
        this.field = field;
        this.fieldKnown = fieldKnown;
    }

    /**
     * Processes one cycle. Call this method once at the beginning of each cycle, even while the robot is lying on the
     * ground.
     *
     * @param nao the robot
     * @param view the robot's field view
     */
    public void update(Robot nao, LocalFieldView view) {
        double elapsed = nao.getTime() - nowSeconds;
        nowSeconds = nao.getTime();
        odometry.update(nao);
        move(nao, elapsed);
        Optional<CameraPicture> picture = nao.getVision();
        if (picture.isPresent()) {
            Pose camera = nao.getCameraPose();
            recognisePitch(picture.get(), camera, nao.getTeamSide());
            if (fieldKnown) {
                correct(sightings(field, picture.get(), camera, nao.getTeamSide()), camera, nao.isFallen());
            }
        }
    }

    private void move(Robot nao, double elapsed) {
        if (elapsed > 1.5 * Cycle.SECONDS) {
            filter.miss(Math.min(elapsed, MAX_MISSED_SECONDS));
        }
        filter.move(nao.getGyro(), nao.getAcceleration());
        if (odometry.isStanding() && tiltDegrees() < STANDING_DEGREES) {
            Vector3 velocity = odometry.step().times(1 / Cycle.SECONDS);
            filter.stand(velocity.x(), velocity.y(), odometry.height());
        }
    }

    /**
     * Sets the estimated pose, for example after a beam.
     *
     * @param newPose the pose in the coordinates of the robot's team
     */
    public void setPose(Pose2d newPose) {
        filter.begin(newPose, SET_METRES, SET_DEGREES);
        known = true;
    }

    /**
     * {@return the robot's pose in team coordinates; the centre of the field until two landmarks have been
     * seen in one picture}
     */
    public Pose2d pose() {
        return filter.pose();
    }

    /** {@return the field; the beginners' field until two landmarks have been seen in one picture} */
    public SoccerField field() {
        return field;
    }

    /** {@return whether the pose is known: two landmarks have been seen in one picture, or it has been set} */
    public boolean isKnown() {
        return known;
    }

    /** {@return the time in seconds since the last correction based on a landmark; infinite if there was none} */
    public double ageSeconds() {
        return nowSeconds - seenSeconds;
    }

    /** {@return the height of the torso's centre above the ground, in metres} */
    public double heightMetres() {
        return filter.torso().position().z();
    }

    /** {@return the forward tilt of the torso in degrees; 90 if the robot is lying on its front} */
    public double leanDegrees() {
        double down = -filter.torso().rotation().apply(new Vector3(1, 0, 0)).z();
        return PortableMath.toDegrees(PortableMath.asin(Math.max(-1, Math.min(1, down))));
    }

    /** {@return the tilt of the torso to the right in degrees} */
    public double rollDegrees() {
        Rotation rotation = filter.torso().rotation();
        double left = rotation.apply(new Vector3(0, 1, 0)).z();
        double up = rotation.apply(new Vector3(0, 0, 1)).z();
        return Angles.atan2(left, up);
    }

    /** {@return the tilt of the torso in degrees, in any direction: 0 upright, 90 lying} */
    public double tiltDegrees() {
        return BodyState.tiltDegrees(filter.torso().rotation().apply(new Vector3(0, 0, 1)));
    }

    /**
     * Compensates for the tilt of the torso: to a robot that is leaning forward, the ball appears higher than it is.
     *
     * @param seen position in metres relative to any point of the torso, along its axes: x forward, y left, z up
     * @return the position relative to the same point: x forward and y left in the horizontal plane, z up
     */
    public Vector3 levelled(Vector3 seen) {
        Rotation heading = Rotation.about(new Vector3(0, 0, 1), -pose().degrees());
        return heading.apply(filter.torso().rotation().apply(seen));
    }

    /** {@return the odometry, which this class updates} */
    public Odometry odometry() {
        return odometry;
    }

    private void correct(List<Sighting> sightings, Pose camera, boolean fallen) {
        boolean lost = !known || contradictions >= PICTURES_TO_DOUBT;
        if (lost && !fallen && sightings.size() >= 2 && distanceError(sightings) < CERTAIN_METRES) {
            filter.begin(fit(sightings), FIT_METRES, FIT_DEGREES);
            known = true;
            contradictions = 0;
            seenSeconds = nowSeconds;
        } else if (known && !sightings.isEmpty()) {
            believe(sightings, camera);
            seenSeconds = nowSeconds;
        }
    }

    /**
     * Corrects the pose using the sightings, and counts successive pictures that contradict it: after several of them,
     * the pose is discarded, so a robot that has been moved localises itself again.
     */
    private void believe(List<Sighting> sightings, Pose camera) {
        long strange = sightings.stream()
                .filter(sighting -> !filter.see(sighting.map, sighting.direction, camera))
                .count();
        contradictions = 2 * strange >= sightings.size() ? contradictions + 1 : 0;
    }

    private void recognisePitch(CameraPicture picture, Pose camera, TeamSide side) {
        for (SoccerField pitch : PITCHES) {
            List<Sighting> sightings = fieldKnown ? List.of() : sightings(pitch, picture, camera, side);
            if (sightings.size() >= 2 && distanceError(sightings) < CERTAIN_METRES) {
                field = pitch;
                fieldKnown = true;
            }
        }
    }

    /**
     * Returns the largest difference, in metres, between the measured distances from the first landmark to the others and the
     * corresponding distances on the map.
     */
    private static double distanceError(List<Sighting> sightings) {
        Sighting first = sightings.get(0);
        return sightings.stream()
                .mapToDouble(other -> Math.abs(first.seen.distanceTo(other.seen) - first.map.distanceTo(other.map)))
                .max()
                .orElse(0);
    }

    private static List<Sighting> sightings(SoccerField field, CameraPicture picture, Pose camera, TeamSide side) {
        return picture.sightings().stream()
                .flatMap(seen -> position(field, seen.name()).stream()
                        .map(place -> sighting(place, seen.direction(), camera, side)))
                .toList();
    }

    /** Returns the position of a landmark or marking; empty if the name is neither, or if the field has no such marking. */
    private static Optional<Vector3> position(SoccerField field, String name) {
        if (LANDMARKS.contains(name)) {
            return Optional.of(field.position(Landmark.valueOf(name)));
        }
        return field.equals(SoccerField.SEVEN) ? Optional.ofNullable(MARKINGS.get(name)) : Optional.empty();
    }

    private static Sighting sighting(Vector3 place, Direction seen, Pose camera, TeamSide side) {
        return new Sighting(seen, camera.transform(seen.toPoint()), side.inOtherFrame(place));
    }

    /**
     * Returns the weighted least-squares fit of the sightings to the map. Closer landmarks have more weight, because
     * errors grow with distance. In the plane, the fit has a closed form (Procrustes problem without scaling).
     */
    private static Pose2d fit(List<Sighting> sightings) {
        Vector3 seenMiddle = Vector3.ZERO;
        Vector3 mapMiddle = Vector3.ZERO;
        double sum = 0;
        for (Sighting sighting : sightings) {
            double weight = weight(sighting);
            seenMiddle = seenMiddle.plus(sighting.seen.times(weight));
            mapMiddle = mapMiddle.plus(sighting.map.times(weight));
            sum += weight;
        }
        seenMiddle = seenMiddle.times(1 / sum);
        mapMiddle = mapMiddle.times(1 / sum);
        double along = 0;
        double across = 0;
        for (Sighting sighting : sightings) {
            Vector3 seen = sighting.seen.minus(seenMiddle);
            Vector3 map = sighting.map.minus(mapMiddle);
            along += weight(sighting) * (seen.x() * map.x() + seen.y() * map.y());
            across += weight(sighting) * (seen.x() * map.y() - seen.y() * map.x());
        }
        Pose2d turned = new Pose2d(0, 0, Angles.atan2(across, along));
        Vector3 offset = mapMiddle.minus(turned.toFrame(seenMiddle));
        return new Pose2d(offset.x(), offset.y(), turned.degrees());
    }

    private static double weight(Sighting sighting) {
        return 1 / Math.max(0.01, sighting.seen.dot(sighting.seen));
    }
}

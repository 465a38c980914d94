package org.robonewbie.agent.localisation;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.robonewbie.agent.Robot;
import org.robonewbie.agent.perception.CameraPicture;
import org.robonewbie.agent.perception.Direction;
import org.robonewbie.agent.perception.LocalFieldView;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Landmark;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.kinematics.ForwardKinematics;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.model.RobotType;

/**
 * Estimates where on the pitch the robot is: {@link Odometry} advances the last pose, and each landmark in a picture corrects it
 * by what it shows, together with the height and the tilt of the camera (a Kalman filter). To begin with, the robot needs two
 * landmarks in one picture: they determine the pose, by the best rigid fit of what is seen to the map.
 *
 * <p>It also finds out which pitch it is: no two of the known pitches have their goal posts and flags at the same distances.
 *
 * <p>Coordinates are those of the robot's team: x towards the opponents' goal, y to the left, the origin in the centre spot.
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
    private static final double LONGEST_MISS_SECONDS = 10;

    private static final Set<String> LANDMARKS =
            Arrays.stream(Landmark.values()).map(Landmark::name).collect(Collectors.toSet());
    private static final List<SoccerField> PITCHES = List.of(SoccerField.BEGINNER, SoccerField.LEAGUE);
    private static final double CERTAIN_METRES = 0.3;

    private SoccerField field;
    private boolean fieldKnown;
    private final Odometry odometry = new Odometry();
    private final ForwardKinematics kinematics = ForwardKinematics.of(RobotType.TYPE_0);
    private final ErrorStateKalmanFilter filter = new ErrorStateKalmanFilter();
    private int contradictions;
    private boolean known;
    private double seenSeconds = Double.NEGATIVE_INFINITY;
    private double nowSeconds = Double.NaN;

    /** A landmark in the picture: where the camera sees it, where that is from the torso, and where it stands. */
    private record Sighting(Direction direction, Vector3 seen, Vector3 map) {}

    /** Creates a robot that does not know where it is, nor on which pitch. */
    public SelfLocalisation() {
        this(SoccerField.BEGINNER, false);
    }

    /**
     * Creates a robot that does not know where it is.
     *
     * @param field the pitch with its landmarks
     */
    public SelfLocalisation(SoccerField field) {
        this(field, true);
    }

    private SelfLocalisation(SoccerField field, boolean fieldKnown) {
        this.field = field;
        this.fieldKnown = fieldKnown;
    }

    /**
     * Takes in one cycle; call it once in each cycle, first of all, also while the robot lies.
     *
     * @param nao the robot
     * @param view what it sees
     */
    public void update(Robot nao, LocalFieldView view) {
        double elapsed = nao.getTime() - nowSeconds;
        nowSeconds = nao.getTime();
        odometry.update(nao);
        move(nao, elapsed);
        Optional<CameraPicture> picture = nao.getVision();
        if (picture.isPresent()) {
            Pose camera = kinematics.camera(nao.getJointAngle(Joint.NECK_YAW), nao.getJointAngle(Joint.NECK_PITCH));
            recognisePitch(picture.get(), camera, nao.getTeamSide());
            if (fieldKnown) {
                correct(sightings(field, picture.get(), camera, nao.getTeamSide()), camera, nao.isFallen());
            }
        }
    }

    private void move(Robot nao, double elapsed) {
        if (elapsed > 1.5 * Cycle.SECONDS) {
            filter.miss(Math.min(elapsed, LONGEST_MISS_SECONDS));
        }
        filter.move(nao.getGyro(), nao.getAcceleration());
        if (odometry.isStanding() && tiltDegrees() < STANDING_DEGREES) {
            Vector3 velocity = odometry.step().times(1 / Cycle.SECONDS);
            filter.stand(velocity.x(), velocity.y(), odometry.height());
        }
    }

    /**
     * Sets where the robot believes to be, after a beam for example.
     *
     * @param newPose in the coordinates of the robot's team
     */
    public void setPose(Pose2d newPose) {
        filter.begin(newPose, SET_METRES, SET_DEGREES);
        known = true;
    }

    /** {@return the robot's pose in the coordinates of its team; the centre spot until it has seen two landmarks at once} */
    public Pose2d pose() {
        return filter.pose();
    }

    /** {@return the pitch; that of the beginners until two landmarks were seen at once} */
    public SoccerField field() {
        return field;
    }

    /** {@return whether the pose is more than a guess: two landmarks were seen at once, or it was set} */
    public boolean isKnown() {
        return known;
    }

    /** {@return seconds since a landmark has confirmed the pose; infinite if none has} */
    public double ageSeconds() {
        return nowSeconds - seenSeconds;
    }

    /** {@return height of the torso's centre above the ground, metres} */
    public double heightMetres() {
        return filter.torso().position().z();
    }

    /** {@return how much the torso bows forward, degrees; 90 if it lies on the front} */
    public double leanDegrees() {
        double down = -filter.torso().rotation().apply(new Vector3(1, 0, 0)).z();
        return PortableMath.toDegrees(PortableMath.asin(Math.max(-1, Math.min(1, down))));
    }

    /** {@return how much the torso leans to the right, degrees} */
    public double rollDegrees() {
        Rotation rotation = filter.torso().rotation();
        double left = rotation.apply(new Vector3(0, 1, 0)).z();
        double up = rotation.apply(new Vector3(0, 0, 1)).z();
        return Angles.atan2(left, up);
    }

    /** {@return how far the torso leans to any side, degrees: 0 upright, 90 lying} */
    public double tiltDegrees() {
        return BodyState.tiltDegrees(filter.torso().rotation().apply(new Vector3(0, 0, 1)));
    }

    /**
     * Turns what is seen as if the torso were upright: a robot that bows forward sees the ball higher than it lies.
     *
     * @param seen x forward, y left and z up along the torso's own axes, from anywhere in it, in metres
     * @return x forward, y left on the level ground and z straight up, from the same place
     */
    public Vector3 levelled(Vector3 seen) {
        Rotation heading = Rotation.about(new Vector3(0, 0, 1), -pose().degrees());
        return heading.apply(filter.torso().rotation().apply(seen));
    }

    /** {@return the movement alone, kept up to date by this class} */
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

    /** What several pictures contradict is given up, so that a robot that was carried away finds its place again. */
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

    /** How much the distances between the landmarks differ from those on the map, in metres at the most. */
    private static double distanceError(List<Sighting> sightings) {
        Sighting first = sightings.get(0);
        return sightings.stream()
                .mapToDouble(other -> Math.abs(first.seen.distanceTo(other.seen) - first.map.distanceTo(other.map)))
                .max()
                .orElse(0);
    }

    private static List<Sighting> sightings(SoccerField field, CameraPicture picture, Pose camera, TeamSide side) {
        return picture.sightings().stream()
                .filter(seen -> LANDMARKS.contains(seen.name()))
                .map(seen -> sighting(field.position(Landmark.valueOf(seen.name())), seen.direction(), camera, side))
                .toList();
    }

    private static Sighting sighting(Vector3 place, Direction seen, Pose camera, TeamSide side) {
        Vector3 map = side == TeamSide.LEFT ? place : new Vector3(-place.x(), -place.y(), place.z());
        return new Sighting(seen, camera.transform(seen.toPoint()), map);
    }

    /**
     * The pose from which all landmarks are seen best, in the sense of least squares; near ones count more, since errors grow
     * with the distance. In the plane this has a closed form (Procrustes' problem without scaling).
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

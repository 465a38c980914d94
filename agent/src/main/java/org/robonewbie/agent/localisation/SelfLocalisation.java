package org.robonewbie.agent.localisation;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.agent.Robot;
import org.robonewbie.agent.perception.FieldItem;
import org.robonewbie.agent.perception.LocalFieldView;
import org.robonewbie.nao.Landmark;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;

/**
 * Estimates where on the pitch the robot is: {@link Odometry} advances the last pose, and each picture with landmarks pulls it
 * to where they show the robot to be. Two landmarks determine the pose, by the best rigid fit of what is seen to the map; a
 * single one determines the position if the heading is known.
 *
 * <p>It also finds out which pitch it is: no two of the known pitches have their goal posts and flags at the same distances.
 *
 * <p>Coordinates are those of the robot's team: x towards the opponents' goal, y to the left, the origin in the centre spot.
 *
 * <pre>{@code
 * private final SelfLocalisation self = new SelfLocalisation();
 * // at the beginning of think():
 * self.update(nao, fieldView);
 * nao.tellPose(self.pose().x(), self.pose().y(), self.pose().headingDegrees());   // for the studio
 * }</pre>
 */
public final class SelfLocalisation {

    private static final double SHARE_OF_FIT = 0.3;
    private static final double SHARE_OF_SINGLE = 0.1;

    private static final List<SoccerField> PITCHES = List.of(SoccerField.BEGINNER, SoccerField.LEAGUE);
    private static final double CERTAIN_METRES = 0.3;

    private SoccerField field;
    private boolean fieldKnown;
    private final Odometry odometry = new Odometry();
    private GroundPose pose = GroundPose.ORIGIN;
    private GroundPose odometryBefore = GroundPose.ORIGIN;
    private boolean known;
    private double seenSeconds = Double.NEGATIVE_INFINITY;
    private double nowSeconds;

    /** A landmark in the picture: where it is seen and where it stands. */
    private record Sighting(Vector3 seen, Vector3 map) {}

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
     * Takes in one cycle; call it once in each cycle, first of all.
     *
     * @param nao the robot
     * @param view what it sees
     */
    public void update(Robot nao, LocalFieldView view) {
        nowSeconds = nao.getTime();
        odometry.update(nao);
        GroundPose now = odometry.pose();
        Vector3 step = odometryBefore.fromFrame(new Vector3(now.x(), now.y(), 0));
        pose = pose.moved(step.x(), step.y(), now.headingDegrees() - odometryBefore.headingDegrees());
        odometryBefore = now;
        if (nao.getVision().isPresent() && !nao.isFallen()) {
            recognisePitch(view, nao.getTeamSide());
            correct(fieldKnown ? sightings(field, view, nao.getTeamSide()) : List.of());
        }
    }

    /**
     * Sets where the robot believes to be, after a beam for example.
     *
     * @param newPose in the coordinates of the robot's team
     */
    public void setPose(GroundPose newPose) {
        pose = newPose;
        known = true;
    }

    /** {@return the robot's pose in the coordinates of its team; the centre spot until it has seen two landmarks at once} */
    public GroundPose pose() {
        return pose;
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

    /** {@return the movement alone, kept up to date by this class} */
    public Odometry odometry() {
        return odometry;
    }

    private void correct(List<Sighting> sightings) {
        if (sightings.size() >= 2) {
            GroundPose fit = fit(sightings);
            pose = known ? pose.towards(fit, SHARE_OF_FIT) : fit;
            known = true;
            seenSeconds = nowSeconds;
        } else if (sightings.size() == 1 && known) {
            Sighting only = sightings.get(0);
            Vector3 believed = pose.toFrame(only.seen);
            Vector3 miss = only.map.minus(believed);
            GroundPose shifted = new GroundPose(pose.x() + miss.x(), pose.y() + miss.y(), pose.headingDegrees());
            pose = pose.towards(shifted, SHARE_OF_SINGLE);
            seenSeconds = nowSeconds;
        }
    }

    private void recognisePitch(LocalFieldView view, TeamSide side) {
        for (SoccerField pitch : PITCHES) {
            List<Sighting> sightings = fieldKnown ? List.of() : sightings(pitch, view, side);
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

    private static List<Sighting> sightings(SoccerField field, LocalFieldView view, TeamSide side) {
        List<Sighting> sightings = new ArrayList<>();
        for (Landmark landmark : Landmark.values()) {
            FieldItem item = view.landmark(landmark);
            if (item.isKnown() && item.ageSeconds() == 0) {
                Vector3 place = field.position(landmark);
                sightings.add(new Sighting(item.position(), side == TeamSide.LEFT ? place : place.times(-1)));
            }
        }
        return sightings;
    }

    /**
     * The pose from which all landmarks are seen best, in the sense of least squares; near ones count more, since errors grow
     * with the distance. In the plane this has a closed form (Procrustes' problem without scaling).
     */
    private static GroundPose fit(List<Sighting> sightings) {
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
        GroundPose turned = new GroundPose(0, 0, PortableMath.toDegrees(PortableMath.atan2(across, along)));
        Vector3 offset = mapMiddle.minus(turned.toFrame(seenMiddle));
        return new GroundPose(offset.x(), offset.y(), turned.headingDegrees());
    }

    private static double weight(Sighting sighting) {
        return 1 / Math.max(0.01, sighting.seen.dot(sighting.seen));
    }
}

package org.robonewbie.protocol.perceptor;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.robonewbie.nao.BodyPart;
import org.robonewbie.nao.FieldMarking;
import org.robonewbie.nao.Landmark;
import org.robonewbie.nao.Vector3;

/**
 * The objects recognised in one camera image: perceptor {@code See}, sent in every third cycle. The lists keep the
 * order of the message, which is arbitrary.
 *
 * @param landmarks goal posts and flags
 * @param ball the ball's centre
 * @param players robots, including the observer if it sees its own arms
 * @param lines segments of the field lines, clipped at the edge of the image
 * @param ownPosition true position of the robot's head in its team's frame in metres; empty unless the server is
 *     configured to send it
 * @param ownOrientationDegrees true direction of the robot's head in its team's frame in degrees, 0 towards the
 *     opponents' goal, positive to the left; empty unless the server is configured to send it
 * @param ballPosition true position of the ball's centre in the team's frame in metres; empty unless the server is
 *     configured to send it
 * @param markings points of the field lines, which only the cameras of today's league recognise
 */
public record Vision(
        List<SeenLandmark> landmarks,
        Optional<PolarPosition> ball,
        List<SeenPlayer> players,
        List<SeenLine> lines,
        Optional<Vector3> ownPosition,
        OptionalDouble ownOrientationDegrees,
        Optional<Vector3> ballPosition,
        List<SeenMarking> markings) {

    /** A vision percept without any objects. */
    public static final Vision NOTHING = of(List.of(), Optional.empty(), List.of(), List.of());

    /** Stores unmodifiable copies of the lists. */
    public Vision {
        landmarks = List.copyOf(landmarks);
        players = List.copyOf(players);
        lines = List.copyOf(lines);
        markings = List.copyOf(markings);
    }

    /**
     * Creates a vision percept without markings, as of a NAO.
     *
     * @param landmarks goal posts and flags
     * @param ball the ball's centre
     * @param players robots
     * @param lines segments of the field lines
     * @param ownPosition true position of the robot's head
     * @param ownOrientationDegrees true direction of the robot's head
     * @param ballPosition true position of the ball's centre
     */
    public Vision(
            List<SeenLandmark> landmarks,
            Optional<PolarPosition> ball,
            List<SeenPlayer> players,
            List<SeenLine> lines,
            Optional<Vector3> ownPosition,
            OptionalDouble ownOrientationDegrees,
            Optional<Vector3> ballPosition) {
        this(landmarks, ball, players, lines, ownPosition, ownOrientationDegrees, ballPosition, List.of());
    }

    /**
     * A goal post or flag in the image.
     *
     * @param landmark the landmark
     * @param position its position relative to the camera
     */
    public record SeenLandmark(Landmark landmark, PolarPosition position) {}

    /**
     * A point of the field lines in the image.
     *
     * @param marking the point
     * @param position its position relative to the camera
     */
    public record SeenMarking(FieldMarking marking, PolarPosition position) {}

    /**
     * A segment of a field line. The order of its ends is arbitrary.
     *
     * @param start one end, whose angles may be NaN
     * @param end the other end, whose angles may be NaN
     */
    public record SeenLine(PolarPosition start, PolarPosition end) {}

    /**
     * A part of a robot's body in the image.
     *
     * @param part the part
     * @param position position of its centre relative to the camera
     */
    public record SeenBodyPart(BodyPart part, PolarPosition position) {}

    /**
     * A robot in the image.
     *
     * @param team name of the robot's team
     * @param number shirt number
     * @param parts visible parts of the body
     * @param position position of the whole robot, which very old servers send instead of the parts
     */
    public record SeenPlayer(String team, int number, List<SeenBodyPart> parts, Optional<PolarPosition> position) {

        /** Stores an unmodifiable copy of the list. */
        public SeenPlayer {
            parts = List.copyOf(parts);
        }
    }

    /**
     * Creates a vision percept without ground-truth positions.
     *
     * @param landmarks goal posts and flags
     * @param ball the ball's centre
     * @param players robots
     * @param lines segments of the field lines
     * @return the percept
     */
    public static Vision of(
            List<SeenLandmark> landmarks,
            Optional<PolarPosition> ball,
            List<SeenPlayer> players,
            List<SeenLine> lines) {
        return new Vision(landmarks, ball, players, lines, Optional.empty(), OptionalDouble.empty(), Optional.empty());
    }
}

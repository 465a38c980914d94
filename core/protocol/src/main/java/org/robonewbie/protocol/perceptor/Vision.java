package org.robonewbie.protocol.perceptor;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.robonewbie.nao.BodyPart;
import org.robonewbie.nao.Landmark;
import org.robonewbie.nao.Vector3;

/**
 * What the camera recognises in one picture: perceptor {@code See}, sent in every third cycle. The order within the lists is
 * that of the message and has no meaning.
 *
 * @param landmarks goal posts and flags
 * @param ball the ball's centre
 * @param players robots, including the observer itself if it sees its own arms
 * @param lines segments of the field lines, clipped at the edge of the picture
 * @param ownPosition the true position of the robot's head in its team's view of the field, in metres; only if the server is
 *     configured to send it
 * @param ownOrientationDegrees the true direction of the robot's head in its team's view, 0 towards the opponents' goal,
 *     positive to the left; only if the server is configured to send it
 * @param ballPosition the true position of the ball's centre in the team's view in metres; only if the server is configured to
 *     send it
 */
public record Vision(
        List<SeenLandmark> landmarks,
        Optional<PolarPosition> ball,
        List<SeenPlayer> players,
        List<SeenLine> lines,
        Optional<Vector3> ownPosition,
        OptionalDouble ownOrientationDegrees,
        Optional<Vector3> ballPosition) {

    /** A picture in which nothing is recognised. */
    public static final Vision NOTHING = of(List.of(), Optional.empty(), List.of(), List.of());

    /** Makes the lists unmodifiable. */
    public Vision {
        landmarks = List.copyOf(landmarks);
        players = List.copyOf(players);
        lines = List.copyOf(lines);
    }

    /**
     * A goal post or flag in the picture.
     *
     * @param landmark which one
     * @param position where it is seen
     */
    public record SeenLandmark(Landmark landmark, PolarPosition position) {}

    /**
     * A segment of a field line; the order of its ends has no meaning.
     *
     * @param start one end; an angle may be NaN
     * @param end the other end; an angle may be NaN
     */
    public record SeenLine(PolarPosition start, PolarPosition end) {}

    /**
     * A part of a robot's body.
     *
     * @param part which part
     * @param position where its centre is seen
     */
    public record SeenBodyPart(BodyPart part, PolarPosition position) {}

    /**
     * A robot in the picture.
     *
     * @param team name of its team
     * @param number its shirt number
     * @param parts the visible parts of its body
     * @param position position of the robot as a whole; sent instead of the parts by very old servers only
     */
    public record SeenPlayer(String team, int number, List<SeenBodyPart> parts, Optional<PolarPosition> position) {

        /** Makes the list unmodifiable. */
        public SeenPlayer {
            parts = List.copyOf(parts);
        }
    }

    /**
     * Creates the picture of a server that does not send true positions.
     *
     * @param landmarks goal posts and flags
     * @param ball the ball's centre
     * @param players robots
     * @param lines segments of the field lines
     * @return the picture
     */
    public static Vision of(
            List<SeenLandmark> landmarks,
            Optional<PolarPosition> ball,
            List<SeenPlayer> players,
            List<SeenLine> lines) {
        return new Vision(landmarks, ball, players, lines, Optional.empty(), OptionalDouble.empty(), Optional.empty());
    }
}

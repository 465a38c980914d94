package org.robonewbie.protocol.perceptor;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.robonewbie.nao.BodyPart;
import org.robonewbie.nao.Landmark;
import org.robonewbie.nao.Vector3;

/**
 * What the camera recognises in one picture: perceptor {@code See}, sent in each third cycle. The order within the lists is
 * that of the message and carries no meaning.
 *
 * @param landmarks goal posts and flags
 * @param ball the ball's centre
 * @param players robots, the observer itself among them if it sees its own arms
 * @param lines pieces of the field lines, cut at the edge of the picture
 * @param ownPosition the true position of the own head in the own team's view of the field, in metres; only if the server is
 *     set up to send it
 * @param ownOrientationDegrees the true direction of the own head in the own team's view, 0 towards the opponents' goal, left
 *     is positive; only if the server is set up to send it
 * @param ballPosition the true position of the ball's centre in the own team's view in metres; only if the server is set up
 *     to send it
 */
public record Vision(
        List<SeenLandmark> landmarks,
        Optional<PolarPosition> ball,
        List<SeenPlayer> players,
        List<SeenLine> lines,
        Optional<Vector3> ownPosition,
        OptionalDouble ownOrientationDegrees,
        Optional<Vector3> ballPosition) {

    /** A picture without anything known in it. */
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
     * A piece of a field line; which end is named first carries no meaning.
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
     * @param number number on its shirt
     * @param parts the visible parts of its body
     * @param position where the robot as a whole is seen; sent by very old servers only, instead of the parts
     */
    public record SeenPlayer(String team, int number, List<SeenBodyPart> parts, Optional<PolarPosition> position) {

        /** Makes the list unmodifiable. */
        public SeenPlayer {
            parts = List.copyOf(parts);
        }
    }

    /**
     * Collects what a server without true positions sends.
     *
     * @param landmarks goal posts and flags
     * @param ball the ball's centre
     * @param players robots
     * @param lines pieces of the field lines
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

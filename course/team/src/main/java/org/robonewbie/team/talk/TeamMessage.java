package org.robonewbie.team.talk;

import java.util.Optional;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.geometry.Translation2d;

/**
 * Message from a player to its team: its pose and role, the ball, and the time to reach it. It takes 18 of the 20 characters
 * that the rules allow; {@link Characters} encodes six bits in each.
 *
 * <table>
 * <caption>Bits and resolution</caption>
 * <tr><td>number</td><td>4</td></tr>
 * <tr><td>position</td><td>10 + 10: 4 cm</td></tr>
 * <tr><td>heading</td><td>7: 3 degrees</td></tr>
 * <tr><td>fallen</td><td>1</td></tr>
 * <tr><td>role</td><td>4</td></tr>
 * <tr><td>ball</td><td>10 + 10: 4 cm</td></tr>
 * <tr><td>speed of the ball</td><td>7 + 7: 0.1 m/s</td></tr>
 * <tr><td>seconds since the ball was seen</td><td>5: 0.2 s</td></tr>
 * <tr><td>seconds to the ball</td><td>8: 0.1 s</td></tr>
 * <tr><td>receiver of a pass</td><td>4</td></tr>
 * <tr><td>target of the pass</td><td>8 + 8: 16 cm</td></tr>
 * <tr><td>checksum</td><td>5</td></tr>
 * </table>
 *
 * @param number player number of the speaker, 1 to 11
 * @param pose its pose in team coordinates
 * @param fallen whether it has fallen
 * @param role its role
 * @param ball position of the ball in team coordinates
 * @param ballVelocity velocity of the ball in metres per second
 * @param ballAgeSeconds seconds since it last saw the ball, at most {@link #MAX_AGE_SECONDS}
 * @param secondsToBall seconds until it could play the ball
 * @param receiver player number of the receiver of a pass; 0 for none
 * @param passTarget target of the pass
 */
public record TeamMessage(
        int number,
        Pose2d pose,
        boolean fallen,
        TeamRole role,
        Translation2d ball,
        Translation2d ballVelocity,
        double ballAgeSeconds,
        double secondsToBall,
        int receiver,
        Translation2d passTarget) {

    /** Maximum age of a ball sighting in a message, in seconds; older sightings are sent with this age. */
    public static final double MAX_AGE_SECONDS = 6.2;

    private static final int LENGTH = 18;
    private static final double MAX_METRES = 20.5;
    private static final double MAX_SPEED = 6.35;

    /** {@return the encoded message of 18 characters} */
    public String encode() {
        Characters text = new Characters(LENGTH, "");
        text.write(number, 4);
        write(text, pose.translation(), 10, MAX_METRES);
        text.write(pose.degrees(), 7, -180, 180);
        text.write(fallen ? 1 : 0, 1);
        text.write(role.ordinal(), 4);
        write(text, ball, 10, MAX_METRES);
        write(text, ballVelocity, 7, MAX_SPEED);
        text.write(ballAgeSeconds, 5, 0, MAX_AGE_SECONDS);
        text.write(secondsToBall, 8, 0, 25.5);
        text.write(receiver, 4);
        write(text, passTarget, 8, MAX_METRES);
        return text.finish();
    }

    private static void write(Characters text, Translation2d spot, int bits, double most) {
        text.write(spot.x(), bits, -most, most);
        text.write(spot.y(), bits, -most, most);
    }

    /**
     * Decodes a message.
     *
     * @param text the received text
     * @return the message; empty if it does not come from this team's program
     */
    public static Optional<TeamMessage> decode(String text) {
        return Characters.of(text, LENGTH, "")
                .map(TeamMessage::read)
                .filter(message -> message.number > 0 && message.number <= 11);
    }

    private static TeamMessage read(Characters text) {
        int number = text.read(4);
        Translation2d place = readSpot(text, 10, MAX_METRES);
        double heading = text.read(7, -180, 180);
        boolean fallen = text.read(1) == 1;
        TeamRole role = TeamRole.values()[text.read(4) % TeamRole.values().length];
        Translation2d ball = readSpot(text, 10, MAX_METRES);
        Translation2d velocity = readSpot(text, 7, MAX_SPEED);
        double age = text.read(5, 0, MAX_AGE_SECONDS);
        double seconds = text.read(8, 0, 25.5);
        int receiver = text.read(4);
        Translation2d target = readSpot(text, 8, MAX_METRES);
        Pose2d pose = new Pose2d(place.x(), place.y(), heading);
        return new TeamMessage(number, pose, fallen, role, ball, velocity, age, seconds, receiver, target);
    }

    private static Translation2d readSpot(Characters text, int bits, double most) {
        double x = text.read(bits, -most, most);
        return new Translation2d(x, text.read(bits, -most, most));
    }
}

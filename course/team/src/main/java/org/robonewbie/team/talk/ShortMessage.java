package org.robonewbie.team.talk;

import java.util.Optional;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.geometry.Translation2d;

/**
 * {@link TeamMessage} in the 10 characters that RCSSServerMJ allows: without the velocity of the ball and passes, and with all else
 * rounded more. That server does not tell from which team a message comes, so the checksum depends on the team.
 *
 * <table>
 * <caption>Bits and resolution</caption>
 * <tr><td>number</td><td>4</td></tr>
 * <tr><td>position</td><td>8 + 8: 22 cm</td></tr>
 * <tr><td>heading</td><td>5: 12 degrees</td></tr>
 * <tr><td>fallen</td><td>1</td></tr>
 * <tr><td>role</td><td>4</td></tr>
 * <tr><td>ball</td><td>8 + 8: 22 cm</td></tr>
 * <tr><td>seconds since the ball was seen</td><td>3: 0.9 s</td></tr>
 * <tr><td>seconds to the ball</td><td>6: 1 s</td></tr>
 * <tr><td>checksum</td><td>5</td></tr>
 * </table>
 */
public final class ShortMessage {

    private static final int LENGTH = 10;
    private static final double MAX_METRES = 28;
    private static final double MAX_SECONDS = 63;

    private ShortMessage() {}

    /**
     * Encodes a message.
     *
     * @param message the message
     * @param team name of the team
     * @return the text of 10 characters
     */
    public static String encode(TeamMessage message, String team) {
        Characters text = new Characters(LENGTH, team);
        text.write(message.number(), 4);
        write(text, message.pose().translation());
        text.write(message.pose().degrees(), 5, -180, 180);
        text.write(message.fallen() ? 1 : 0, 1);
        text.write(message.role().ordinal(), 4);
        write(text, message.ball());
        text.write(message.ballAgeSeconds(), 3, 0, TeamMessage.MAX_AGE_SECONDS);
        text.write(message.secondsToBall(), 6, 0, MAX_SECONDS);
        return text.finish();
    }

    private static void write(Characters text, Translation2d spot) {
        text.write(spot.x(), 8, -MAX_METRES, MAX_METRES);
        text.write(spot.y(), 8, -MAX_METRES, MAX_METRES);
    }

    /**
     * Decodes a message.
     *
     * @param text the received text
     * @param team name of the team
     * @return the message; empty if it does not come from this team
     */
    public static Optional<TeamMessage> decode(String text, String team) {
        return Characters.of(text, LENGTH, team)
                .map(ShortMessage::read)
                .filter(message -> message.number() > 0 && message.number() <= 11);
    }

    private static TeamMessage read(Characters text) {
        int number = text.read(4);
        Translation2d place = readSpot(text);
        double heading = text.read(5, -180, 180);
        boolean fallen = text.read(1) == 1;
        TeamRole role = TeamRole.values()[text.read(4) % TeamRole.values().length];
        Translation2d ball = readSpot(text);
        double age = text.read(3, 0, TeamMessage.MAX_AGE_SECONDS);
        double seconds = text.read(6, 0, MAX_SECONDS);
        Pose2d pose = new Pose2d(place.x(), place.y(), heading);
        return new TeamMessage(
                number, pose, fallen, role, ball, Translation2d.ORIGIN, age, seconds, 0, Translation2d.ORIGIN);
    }

    private static Translation2d readSpot(Characters text) {
        double x = text.read(8, -MAX_METRES, MAX_METRES);
        return new Translation2d(x, text.read(8, -MAX_METRES, MAX_METRES));
    }
}

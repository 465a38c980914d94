package org.robonewbie.team.world;

import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.team.talk.TeamMessage;

/**
 * A teammate, as described by its last message.
 *
 * @param message its last message
 * @param heardSeconds simulated time in seconds at which the message was heard
 */
public record Mate(TeamMessage message, double heardSeconds) {

    /** {@return its player number, 1 to 11} */
    public int number() {
        return message.number();
    }

    /** {@return its position in team coordinates} */
    public Translation2d place() {
        return message.pose().translation();
    }
}

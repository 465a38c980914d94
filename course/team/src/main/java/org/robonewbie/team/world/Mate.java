package org.robonewbie.team.world;

import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.team.talk.TeamMessage;

/**
 * A team mate as it has presented itself.
 *
 * @param message what it has said last
 * @param heardSeconds when, in simulated seconds
 */
public record Mate(TeamMessage message, double heardSeconds) {

    /** {@return the number on its shirt, 1 to 11} */
    public int number() {
        return message.number();
    }

    /** {@return where it stands, in the coordinates of the team} */
    public Pose2d pose() {
        return message.pose();
    }

    /** {@return its place, in the coordinates of the team} */
    public Translation2d place() {
        return message.pose().translation();
    }
}

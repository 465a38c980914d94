package org.robonewbie.protocol.monitor;

import java.util.Optional;

/** The fouls that monitors know, in the order of their numbers in SimSpark's messages. */
public enum FoulType {
    /** Too many robots of a team near the ball. */
    CROWDING,
    /** Too many robots touch each other. */
    TOUCHING,
    /** Too many defenders in their own penalty area. */
    ILLEGAL_DEFENCE,
    /** Too many attackers in the opponents' penalty area; rcssserver3d never calls it. */
    ILLEGAL_ATTACK,
    /** A robot stays on the ground for too long. */
    INCAPABLE,
    /** An infringement at the kick-off; rcssserver3d never calls it. */
    ILLEGAL_KICK_OFF,
    /** A robot runs into an opponent. */
    CHARGING,
    /** Parts of one robot's body run into each other. */
    SELF_COLLISION,
    /** A robot keeps the ball for too long; newer servers only. */
    BALL_HOLDING,
    /** The taker of a free kick touches the ball twice; newer servers only. */
    DOUBLE_TOUCHING,
    /** A robot plays the ball with an arm; newer servers only. */
    HAND_FOUL;

    /** {@return the foul's number in SimSpark's messages, 0 to 10} */
    public int simSparkNumber() {
        return ordinal();
    }

    /**
     * Finds a foul by its number in SimSpark's messages.
     *
     * @param simSparkNumber the number
     * @return the foul; empty for a number of a newer server
     */
    public static Optional<FoulType> ofSimSparkNumber(int simSparkNumber) {
        return simSparkNumber >= 0 && simSparkNumber < values().length
                ? Optional.of(values()[simSparkNumber])
                : Optional.empty();
    }
}

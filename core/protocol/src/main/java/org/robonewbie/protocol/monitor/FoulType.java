package org.robonewbie.protocol.monitor;

import java.util.Optional;

/** The types of fouls in monitor messages, in the order of SimSpark's numeric codes. */
public enum FoulType {
    /** Too many robots of a team near the ball. */
    CROWDING,
    /** Too many robots touching each other. */
    TOUCHING,
    /** Too many defenders in their own penalty area. */
    ILLEGAL_DEFENCE,
    /** Too many attackers in the opponents' penalty area; never called by rcssserver3d. */
    ILLEGAL_ATTACK,
    /** A robot on the ground for too long. */
    INCAPABLE,
    /** An infringement at the kick-off; never called by rcssserver3d. */
    ILLEGAL_KICK_OFF,
    /** A robot running into an opponent. */
    CHARGING,
    /** A collision between parts of the same robot. */
    SELF_COLLISION,
    /** A robot holding the ball for too long; newer servers only. */
    BALL_HOLDING,
    /** The taker of a free kick touching the ball twice; newer servers only. */
    DOUBLE_TOUCHING,
    /** A robot playing the ball with an arm; newer servers only. */
    HAND_FOUL;

    /** {@return the numeric code of the foul in SimSpark's messages, 0 to 10} */
    public int simSparkNumber() {
        return ordinal();
    }

    /**
     * Looks up a type of foul by its numeric code in SimSpark's messages.
     *
     * @param simSparkNumber the numeric code
     * @return the type; empty for an unknown code, which a newer server may send
     */
    public static Optional<FoulType> ofSimSparkNumber(int simSparkNumber) {
        return simSparkNumber >= 0 && simSparkNumber < values().length
                ? Optional.of(values()[simSparkNumber])
                : Optional.empty();
    }
}

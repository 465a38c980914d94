package org.robonewbie.nao;

/** The parts of another robot that a camera can recognise; each is reported by the position of its centre. */
public enum BodyPart {
    /** The head. */
    HEAD("head"),
    /** The right forearm. */
    RIGHT_LOWER_ARM("rlowerarm"),
    /** The left forearm. */
    LEFT_LOWER_ARM("llowerarm"),
    /** The right foot. */
    RIGHT_FOOT("rfoot"),
    /** The left foot. */
    LEFT_FOOT("lfoot");

    private final String simSparkName;

    BodyPart(String simSparkName) {
        this.simSparkName = simSparkName;
    }

    /** {@return the part's name in SimSpark's vision messages, such as {@code rlowerarm}} */
    public String simSparkName() {
        return simSparkName;
    }
}

package org.robonewbie.nao;

/** A part of another robot that the camera recognises. Its reported position is the centre of the part. */
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

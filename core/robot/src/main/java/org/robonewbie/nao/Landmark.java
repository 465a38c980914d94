package org.robonewbie.nao;

/** A fixed, named point on the pitch that the camera recognises: the top of a goal post or a corner flag. */
public enum Landmark {
    /** Post of the left goal on the positive y side. */
    GOAL_POST_1_LEFT("G1L", TeamSide.LEFT),
    /** Post of the left goal on the negative y side. */
    GOAL_POST_2_LEFT("G2L", TeamSide.LEFT),
    /** Post of the right goal on the negative y side. */
    GOAL_POST_2_RIGHT("G2R", TeamSide.RIGHT),
    /** Post of the right goal on the positive y side. */
    GOAL_POST_1_RIGHT("G1R", TeamSide.RIGHT),
    /** Corner of the left goal line on the positive y side. */
    FLAG_1_LEFT("F1L", TeamSide.LEFT),
    /** Corner of the left goal line on the negative y side. */
    FLAG_2_LEFT("F2L", TeamSide.LEFT),
    /** Corner of the right goal line on the positive y side. */
    FLAG_1_RIGHT("F1R", TeamSide.RIGHT),
    /** Corner of the right goal line on the negative y side. */
    FLAG_2_RIGHT("F2R", TeamSide.RIGHT);

    private final String simSparkName;
    private final TeamSide side;

    Landmark(String simSparkName, TeamSide side) {
        this.simSparkName = simSparkName;
        this.side = side;
    }

    /** {@return the landmark's name in SimSpark's vision messages, such as {@code G1R}} */
    public String simSparkName() {
        return simSparkName;
    }

    /** {@return the side of the pitch on which the landmark is located} */
    public TeamSide side() {
        return side;
    }
}

package org.robonewbie.nao;

/** What never moves and carries a name on the pitch: the tops of the goal posts and the corner flags. */
public enum Landmark {
    /** Left goal, post on the side of growing y. */
    GOAL_POST_1_LEFT("G1L", TeamSide.LEFT),
    /** Left goal, post on the side of falling y. */
    GOAL_POST_2_LEFT("G2L", TeamSide.LEFT),
    /** Right goal, post on the side of falling y. */
    GOAL_POST_2_RIGHT("G2R", TeamSide.RIGHT),
    /** Right goal, post on the side of growing y. */
    GOAL_POST_1_RIGHT("G1R", TeamSide.RIGHT),
    /** Corner at the left goal line, on the side of growing y. */
    FLAG_1_LEFT("F1L", TeamSide.LEFT),
    /** Corner at the left goal line, on the side of falling y. */
    FLAG_2_LEFT("F2L", TeamSide.LEFT),
    /** Corner at the right goal line, on the side of growing y. */
    FLAG_1_RIGHT("F1R", TeamSide.RIGHT),
    /** Corner at the right goal line, on the side of falling y. */
    FLAG_2_RIGHT("F2R", TeamSide.RIGHT);

    private final String simSparkName;
    private final TeamSide side;

    Landmark(String simSparkName, TeamSide side) {
        this.simSparkName = simSparkName;
        this.side = side;
    }

    /**
     * Names the landmark in SimSpark's vision messages.
     *
     * @return the name, such as {@code G1R}
     */
    public String simSparkName() {
        return simSparkName;
    }

    /**
     * Tells at which end of the pitch the landmark stands.
     *
     * @return the side whose goal line it stands on
     */
    public TeamSide side() {
        return side;
    }

    /**
     * Tells goal posts from flags.
     *
     * @return whether this is a goal post
     */
    public boolean isGoalPost() {
        return simSparkName.charAt(0) == 'G';
    }
}

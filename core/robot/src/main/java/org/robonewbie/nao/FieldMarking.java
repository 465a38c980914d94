package org.robonewbie.nao;

/**
 * A fixed, named point on the pitch of today's league that the cameras of its robots recognise besides the {@link Landmark}s: a penalty
 * spot, or a place where field lines meet.
 *
 * <p>The positions are those of RCSSServerMJ 0.2.1, on its pitch of 55 m × 36 m. This version recognises the corners of the goal areas
 * and penalty areas twice as far from the middle of the goal as they are painted.
 */
public enum FieldMarking {
    /** End of the halfway line on the positive y side. */
    HALFWAY_LINE_1("t_cuf", 0, 18),
    /** End of the halfway line on the negative y side. */
    HALFWAY_LINE_2("t_clf", 0, -18),
    /** Point of the centre circle on the halfway line, on the positive y side. */
    CENTRE_CIRCLE_1("x_cuc", 0, 5.5),
    /** Point of the centre circle on the halfway line, on the negative y side. */
    CENTRE_CIRCLE_2("x_clc", 0, -5.5),
    /** Penalty spot before the left goal. */
    PENALTY_SPOT_LEFT("p_lpm", -20.18, 0),
    /** Penalty spot before the right goal. */
    PENALTY_SPOT_RIGHT("p_rpm", 20.18, 0),
    /** Corner of the left goal area on the positive y side. */
    GOAL_AREA_1_LEFT("l_luga", -23.5, 7.3),
    /** Corner of the left goal area on the negative y side. */
    GOAL_AREA_2_LEFT("l_llga", -23.5, -7.3),
    /** Corner of the right goal area on the positive y side. */
    GOAL_AREA_1_RIGHT("l_ruga", 23.5, 7.3),
    /** Corner of the right goal area on the negative y side. */
    GOAL_AREA_2_RIGHT("l_rlga", 23.5, -7.3),
    /** End of the left goal area on the goal line, on the positive y side. */
    GOAL_AREA_END_1_LEFT("t_luga", -27.5, 7.3),
    /** End of the left goal area on the goal line, on the negative y side. */
    GOAL_AREA_END_2_LEFT("t_llga", -27.5, -7.3),
    /** End of the right goal area on the goal line, on the positive y side. */
    GOAL_AREA_END_1_RIGHT("t_ruga", 27.5, 7.3),
    /** End of the right goal area on the goal line, on the negative y side. */
    GOAL_AREA_END_2_RIGHT("t_rlga", 27.5, -7.3),
    /** Corner of the left penalty area on the positive y side. */
    PENALTY_AREA_1_LEFT("l_lupa", -18.5, 16.5),
    /** Corner of the left penalty area on the negative y side. */
    PENALTY_AREA_2_LEFT("l_llpa", -18.5, -16.5),
    /** Corner of the right penalty area on the positive y side. */
    PENALTY_AREA_1_RIGHT("l_rupa", 18.5, 16.5),
    /** Corner of the right penalty area on the negative y side. */
    PENALTY_AREA_2_RIGHT("l_rlpa", 18.5, -16.5),
    /** End of the left penalty area on the goal line, on the positive y side. */
    PENALTY_AREA_END_1_LEFT("t_lupa", -27.5, 16.5),
    /** End of the left penalty area on the goal line, on the negative y side. */
    PENALTY_AREA_END_2_LEFT("t_llpa", -27.5, -16.5),
    /** End of the right penalty area on the goal line, on the positive y side. */
    PENALTY_AREA_END_1_RIGHT("t_rupa", 27.5, 16.5),
    /** End of the right penalty area on the goal line, on the negative y side. */
    PENALTY_AREA_END_2_RIGHT("t_rlpa", 27.5, -16.5);

    private final String leagueName;
    private final double x;
    private final double y;

    FieldMarking(String leagueName, double x, double y) {
        this.leagueName = leagueName;
        this.x = x;
        this.y = y;
    }

    /** {@return the marking's name in the vision messages of RCSSServerMJ, such as {@code t_cuf}} */
    public String leagueName() {
        return leagueName;
    }

    /** {@return the position in the world frame, in metres: origin at the centre spot, x towards the right goal} */
    public Vector3 position() {
        return new Vector3(x, y, 0);
    }
}

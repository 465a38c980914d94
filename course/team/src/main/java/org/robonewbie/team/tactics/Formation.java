package org.robonewbie.team.tactics;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.team.talk.TeamRole;

/**
 * Positions of the field players that do not play the ball. They depend on the ball, so the whole team moves with it. A
 * team of fewer than eleven fills the positions in order of importance.
 */
public final class Formation {

    private static final List<TeamRole> BY_IMPORTANCE = List.of(
            TeamRole.SUPPORTER,
            TeamRole.FORWARD,
            TeamRole.SWEEPER,
            TeamRole.LEFT_WING,
            TeamRole.RIGHT_WING,
            TeamRole.LEFT_BACK,
            TeamRole.RIGHT_BACK,
            TeamRole.LEFT_MIDFIELD,
            TeamRole.RIGHT_MIDFIELD);
    private static final double EDGE_METRES = 0.8;
    private static final double GOAL_LINE_METRES = 2.2;

    private final SoccerField field;

    /**
     * Creates a formation.
     *
     * @param field the field
     */
    public Formation(SoccerField field) {
        this.field = field;
    }

    /**
     * Returns the most important positions.
     *
     * @param ball position of the ball in team coordinates
     * @param players number of players
     * @return one position per player, at most nine, by role
     */
    public Map<TeamRole, Translation2d> places(Translation2d ball, int players) {
        Map<TeamRole, Translation2d> places = new LinkedHashMap<>();
        BY_IMPORTANCE.stream().limit(players).forEach(role -> places.put(role, place(role, ball)));
        return places;
    }

    /**
     * Returns the position for a role.
     *
     * @param role the role
     * @param ball position of the ball
     * @return its position, on the field and outside the penalty areas
     */
    public Translation2d place(TeamRole role, Translation2d ball) {
        Translation2d ourGoal = new Translation2d(-field.length() / 2, 0);
        double scale = field.length() / 30;
        double middle = ball.y() / 3;
        return inside(
                switch (role) {
                    case FORWARD -> new Translation2d(ball.x() + 5 * scale, middle);
                    case SUPPORTER -> ball.towards(ourGoal, 2.8).plus(new Translation2d(0, ball.y() > 0 ? -0.8 : 0.8));
                    case SWEEPER -> ball.towards(ourGoal, ball.distanceTo(ourGoal) / 2);
                    case LEFT_WING -> new Translation2d(ball.x() + 2 * scale, middle + 5 * scale);
                    case RIGHT_WING -> new Translation2d(ball.x() + 2 * scale, middle - 5 * scale);
                    case LEFT_BACK -> new Translation2d(ball.x() - 6 * scale, middle + 3 * scale);
                    case RIGHT_BACK -> new Translation2d(ball.x() - 6 * scale, middle - 3 * scale);
                    case LEFT_MIDFIELD -> new Translation2d(ball.x() - 3 * scale, middle + 4 * scale);
                    case RIGHT_MIDFIELD -> new Translation2d(ball.x() - 3 * scale, middle - 4 * scale);
                    case KEEPER -> ourGoal.plus(new Translation2d(0.5, 0));
                    case STRIKER -> ball;
                },
                role);
    }

    private Translation2d inside(Translation2d spot, TeamRole role) {
        double mostX = field.length() / 2 - (role == TeamRole.KEEPER ? 0 : GOAL_LINE_METRES);
        double mostY = field.width() / 2 - EDGE_METRES;
        return new Translation2d(
                Math.max(-mostX, Math.min(mostX, spot.x())), Math.max(-mostY, Math.min(mostY, spot.y())));
    }
}

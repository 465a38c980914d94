package org.robonewbie.trial.measure;

import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.trial.WorldState;

/**
 * How long it takes the left team to score, in seconds; without a goal, 10 s more for each metre between the ball and the goal.
 */
public final class TimeToScore extends MeasureFromStart {

    private static final double SECONDS_FOR_EACH_METRE = 10;

    private final SoccerField field;
    private double seconds;
    private boolean scored;

    /** Creates a measure for the beginners' pitch. */
    public TimeToScore() {
        this(SoccerField.BEGINNER);
    }

    /**
     * Creates a measure that has not seen anything.
     *
     * @param field sizes of the pitch
     */
    public TimeToScore(SoccerField field) {
        this.field = field;
    }

    @Override
    protected void see(WorldState first, WorldState now) {
        if (!scored) {
            scored = now.goals(TeamSide.LEFT) > 0 || metresToGoal(field, now.ball()) == 0;
            double missing = scored ? 0 : metresToGoal(field, now.ball());
            seconds = now.seconds() - first.seconds() + SECONDS_FOR_EACH_METRE * missing;
        }
    }

    /**
     * Calculates how much is missing to a goal at the right end.
     *
     * @param field sizes of the pitch
     * @param ball centre of the ball
     * @return metres from the ball to the line between the posts, 0 behind it
     */
    public static double metresToGoal(SoccerField field, Vector3 ball) {
        double ahead = Math.max(0, field.length() / 2 - ball.x());
        double aside = Math.max(0, Math.abs(ball.y()) - field.goalWidth() / 2);
        return PortableMath.hypot(ahead, aside);
    }

    @Override
    public double value() {
        return seconds;
    }

    @Override
    public String unit() {
        return "s";
    }

    @Override
    public boolean isLargerBetter() {
        return false;
    }

    @Override
    public boolean isDecided() {
        return scored;
    }
}

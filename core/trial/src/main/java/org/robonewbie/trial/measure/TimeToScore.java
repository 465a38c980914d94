package org.robonewbie.trial.measure;

import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.trial.WorldState;

/**
 * The time until the left team scores, in seconds, plus a penalty of 10 s for each metre that remains between the ball and the
 * goal.
 */
public final class TimeToScore extends MeasureFromStart {

    private static final double PENALTY_SECONDS_PER_METRE = 10;

    private final SoccerField field;
    private double seconds;
    private boolean scored;

    /** Creates a measure for the beginners' pitch. */
    public TimeToScore() {
        this(SoccerField.BEGINNER);
    }

    /**
     * Creates a measure for a given pitch.
     *
     * @param field dimensions of the pitch
     */
    public TimeToScore(SoccerField field) {
        super("s", false);
        this.field = field;
    }

    @Override
    protected void see(WorldState first, WorldState now) {
        if (!scored) {
            scored = now.goals(TeamSide.LEFT) > 0 || metresToGoal(field, now.ball()) == 0;
            double missing = scored ? 0 : metresToGoal(field, now.ball());
            seconds = now.seconds() - first.seconds() + PENALTY_SECONDS_PER_METRE * missing;
        }
    }

    /**
     * Returns the distance from the ball to the right goal.
     *
     * @param field dimensions of the pitch
     * @param ball centre of the ball
     * @return metres from the ball to the goal line between the posts; 0 if the ball is behind it
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
    public boolean isDecided() {
        return scored;
    }
}

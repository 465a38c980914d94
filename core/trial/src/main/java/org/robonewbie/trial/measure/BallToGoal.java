package org.robonewbie.trial.measure;

import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.trial.Measure;
import org.robonewbie.trial.WorldState;

/**
 * The minimum distance, in metres, from the ball's centre to the right goal line between the posts. A goal by the left
 * team sets the value to 0 and ends the measurement; own goals do not count.
 */
public final class BallToGoal implements Measure {

    private double metres = Double.MAX_VALUE;
    private double lastMetres = Double.MAX_VALUE;
    private double seconds;
    private boolean scored;

    /** Creates a measure for the beginners' pitch. */
    public BallToGoal() {}

    @Override
    public void see(WorldState state) {
        seconds = scored ? seconds : state.seconds();
        scored |= state.goals(TeamSide.LEFT) > 0;
        lastMetres = scored ? 0 : TimeToScore.metresToGoal(SoccerField.BEGINNER, state.ball());
        metres = Math.min(metres, lastMetres);
    }

    /** {@return the time of the goal in seconds; without a goal, the duration of the trial so far} */
    public double seconds() {
        return seconds;
    }

    /** {@return the current distance from the ball to the goal in metres; 0 after a goal} */
    public double lastMetres() {
        return lastMetres;
    }

    @Override
    public double value() {
        return metres;
    }

    @Override
    public String unit() {
        return "m";
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

package org.robonewbie.trial.measure;

import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.trial.Measure;
import org.robonewbie.trial.WorldState;

/**
 * How near the ball has come to the right goal, in metres: from its centre to the nearest point of the goal line between the
 * posts. A goal of the left team makes it 0 and decides; own goals do not count.
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

    /** {@return when the goal was scored; without one, how long the trial has taken so far} */
    public double seconds() {
        return seconds;
    }

    /** {@return how far the ball was from the goal at last, in metres; 0 after a goal} */
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

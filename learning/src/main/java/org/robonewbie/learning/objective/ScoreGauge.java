package org.robonewbie.learning.objective;

/** Measures how long it takes to score. */
final class ScoreGauge extends RememberingGauge {

    private static final double SECONDS_FOR_EACH_METRE = 10;

    private double seconds;
    private boolean scored;

    @Override
    void measure(TrueState start, TrueState now, boolean hasFallen) {
        if (!scored) {
            seconds = now.seconds() - start.seconds() + SECONDS_FOR_EACH_METRE * now.ballToGoal();
            scored = now.isScored();
        }
    }

    @Override
    public double value() {
        return seconds;
    }
}

package org.robonewbie.learning.objective;

/** Measures the distance that the ball covers along the robot's first heading, including an estimate of its further roll. */
final class KickGauge extends RememberingGauge {

    /** A rolling ball comes this much further for each metre per second, as trials show. */
    private static final double ROLLS_ON_SECONDS = 0.94;

    private double metres;

    @Override
    void measure(TrueState start, TrueState now, boolean hasFallen) {
        metres = start.ahead(now.ball().plus(now.ballVelocity().times(ROLLS_ON_SECONDS))) - start.ahead(start.ball());
    }

    @Override
    public double value() {
        return metres;
    }
}

package org.robonewbie.learning.objective;

/** Measures how much the torso leans in the mean. */
final class TiltGauge extends RememberingGauge {

    private static final double FALLEN_DEGREES = 90;

    private double sum;
    private long looks;

    @Override
    void measure(TrueState start, TrueState now, boolean hasFallen) {
        sum += hasFallen ? FALLEN_DEGREES : now.tiltDegrees();
        looks++;
    }

    @Override
    public double value() {
        return looks > 0 ? sum / looks : 0;
    }
}

package org.robonewbie.learning.objective;

/** Measures the distance that the robot covers along its first heading before it falls. */
final class DistanceGauge extends RememberingGauge {

    private double metres;

    @Override
    void measure(TrueState start, TrueState now, boolean hasFallen) {
        if (!hasFallen) {
            metres = start.ahead(now.torso());
        }
    }

    @Override
    public double value() {
        return metres;
    }
}

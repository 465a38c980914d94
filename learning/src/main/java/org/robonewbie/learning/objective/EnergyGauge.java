package org.robonewbie.learning.objective;

/** Measures the work of the motors. */
final class EnergyGauge extends RememberingGauge {

    private double joules;

    @Override
    void measure(TrueState start, TrueState now, boolean hasFallen) {
        joules = now.workJoules() - start.workJoules();
    }

    @Override
    public double value() {
        return joules;
    }
}

package org.robonewbie.learning.objective;

/** Measures the speed of the robot along its first heading; the time of a trial continues after a fall. */
final class SpeedGauge extends RememberingGauge {

    private double metres;
    private double seconds;

    @Override
    void measure(TrueState start, TrueState now, boolean hasFallen) {
        seconds = now.seconds() - start.seconds();
        if (!hasFallen) {
            metres = start.ahead(now.torso());
        }
    }

    @Override
    public double value() {
        return seconds > 0 ? metres / seconds : 0;
    }
}

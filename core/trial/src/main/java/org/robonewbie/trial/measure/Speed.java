package org.robonewbie.trial.measure;

import org.robonewbie.trial.WorldState;

/** The speed of the robot along its first heading, in metres per second; the time continues after a fall. */
public final class Speed extends MeasureFromStart {

    private final Distance distance = new Distance();
    private double seconds;

    /** Creates a measure that has not seen anything. */
    public Speed() {}

    @Override
    protected void see(WorldState first, WorldState now) {
        distance.see(now);
        seconds = now.seconds() - first.seconds();
    }

    @Override
    public double value() {
        return seconds > 0 ? distance.value() / seconds : 0;
    }

    @Override
    public String unit() {
        return "m/s";
    }
}

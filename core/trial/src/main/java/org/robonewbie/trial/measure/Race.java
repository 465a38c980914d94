package org.robonewbie.trial.measure;

import org.robonewbie.trial.WorldState;

/**
 * How long the robot takes to a line across the pitch, in seconds; while it has not crossed the line on its feet, 10 s more for
 * each metre that is missing. The line lies towards the right goal, whichever way the robot faces at first.
 */
public final class Race extends MeasureFromStart {

    private static final double SECONDS_FOR_EACH_METRE = 10;
    private static final double DEFAULT_METRES = 3;

    private final double lineMetres;
    private double metres;
    private double seconds;

    /** Creates a measure of a race over 3 m. */
    public Race() {
        this(DEFAULT_METRES);
    }

    /**
     * Creates a measure that has not seen anything.
     *
     * @param lineMetres distance of the line from the start
     */
    public Race(double lineMetres) {
        this.lineMetres = lineMetres;
    }

    @Override
    protected void see(WorldState first, WorldState now) {
        if (isDecided()) {
            return;
        }
        seconds = now.seconds() - first.seconds();
        if (now.robot().isStanding()) {
            double way = now.robot().position().x() - first.robot().position().x();
            metres = Math.max(metres, Math.min(way, lineMetres));
        }
    }

    /** {@return the greatest distance from the start at which the robot was on its feet, at most that of the line, in metres} */
    public double metres() {
        return metres;
    }

    @Override
    public double value() {
        return seconds + SECONDS_FOR_EACH_METRE * (lineMetres - metres);
    }

    @Override
    public String unit() {
        return "s";
    }

    @Override
    public boolean isLargerBetter() {
        return false;
    }

    @Override
    public boolean isDecided() {
        return metres >= lineMetres;
    }
}

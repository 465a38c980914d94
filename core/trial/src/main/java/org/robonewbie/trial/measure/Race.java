package org.robonewbie.trial.measure;

import org.robonewbie.trial.WorldState;

/**
 * The time in seconds that the robot takes to reach a line across the pitch, plus a penalty of 10 s for each metre by which it
 * falls short of the line. Distance counts only while the robot is upright. The line lies towards the right goal, regardless of
 * the robot's initial heading.
 */
public final class Race extends MeasureFromStart {

    private static final double PENALTY_SECONDS_PER_METRE = 10;
    private static final double DEFAULT_METRES = 3;

    private final double lineMetres;
    private double metres;
    private double seconds;

    /** Creates a measure for a race over 3 m. */
    public Race() {
        this(DEFAULT_METRES);
    }

    /**
     * Creates a measure for a race over a given distance.
     *
     * @param lineMetres distance from the start to the line
     */
    public Race(double lineMetres) {
        super("s", false);
        this.lineMetres = lineMetres;
    }

    @Override
    protected void see(WorldState first, WorldState now) {
        if (isDecided()) {
            return;
        }
        seconds = now.seconds() - first.seconds();
        if (now.robot().isStanding()) {
            double distance =
                    now.robot().position().x() - first.robot().position().x();
            metres = Math.max(metres, Math.min(distance, lineMetres));
        }
    }

    /** {@return the maximum distance that the robot reached while upright, in metres, at most the distance to the line} */
    public double metres() {
        return metres;
    }

    @Override
    public double value() {
        return seconds + PENALTY_SECONDS_PER_METRE * (lineMetres - metres);
    }

    @Override
    public boolean isDecided() {
        return metres >= lineMetres;
    }
}

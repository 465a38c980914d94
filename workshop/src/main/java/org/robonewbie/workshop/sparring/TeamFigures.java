package org.robonewbie.workshop.sparring;

import java.util.Arrays;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;

/** Statistics of one team, of a single match or summed over several. */
final class TeamFigures {

    private static final int BINS = 50;
    private static final double BIN_METRES_PER_SECOND = 0.04;
    private static final int NUMBERS = Figure.values().length;

    /** The figures, followed by a histogram of the speeds of moving players. */
    private final double[] numbers;

    /** Creates figures that are all zero. */
    TeamFigures() {
        this(new double[NUMBERS + BINS]);
    }

    private TeamFigures(double... numbers) {
        this.numbers = numbers;
    }

    /**
     * Reads figures.
     *
     * @throws IllegalArgumentException if the text does not come from {@link #toString}
     */
    static TeamFigures of(String text) {
        double[] read =
                Arrays.stream(text.split(" ")).mapToDouble(Double::parseDouble).toArray();
        if (read.length != NUMBERS + BINS) {
            throw new IllegalArgumentException(
                    "Expected " + (NUMBERS + BINS) + " figures of a team, but found " + read.length + ".");
        }
        return new TeamFigures(read);
    }

    void add(Figure figure, double amount) {
        numbers[figure.ordinal()] += amount;
    }

    /** Adds a speed of a moving player. */
    void addSpeed(double metresPerSecond) {
        numbers[NUMBERS + Math.min(BINS - 1, (int) (metresPerSecond / BIN_METRES_PER_SECOND))]++;
    }

    void add(TeamFigures other) {
        Arrays.setAll(numbers, i -> numbers[i] + other.numbers[i]);
    }

    double get(Figure figure) {
        return numbers[figure.ordinal()];
    }

    /** Returns the ratio of two figures; NaN if the second one is zero. */
    double ratio(Figure figure, Figure to) {
        return get(figure) / get(to);
    }

    /** Returns the speed that a share of all speeds does not exceed, in metres per second; NaN without speeds. */
    double speed(double share) {
        double all = DoubleStream.of(numbers).skip(NUMBERS).sum();
        double below = 0;
        for (int bin = 0; bin < BINS; bin++) {
            double here = numbers[NUMBERS + bin];
            if (here > 0 && below + here >= share * all) {
                return (bin + (share * all - below) / here) * BIN_METRES_PER_SECOND;
            }
            below += here;
        }
        return Double.NaN;
    }

    @Override
    public String toString() {
        return DoubleStream.of(numbers)
                .mapToObj(
                        number -> number == Math.rint(number) ? Long.toString((long) number) : Double.toString(number))
                .collect(Collectors.joining(" "));
    }
}

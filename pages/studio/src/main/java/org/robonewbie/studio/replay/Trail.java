package org.robonewbie.studio.replay;

import java.util.ArrayList;
import java.util.List;

/** A way over the pitch, in at most 256 places however long the run is: later ones are farther apart in time. */
final class Trail {

    private static final int MOST_PLACES = 256;
    private static final double HUNDREDTHS = 100;

    private final List<List<Double>> places = new ArrayList<>();
    private long cyclesPerPlace = 1;
    private long cycles;

    void add(double x, double y) {
        if (cycles % cyclesPerPlace == 0) {
            places.add(List.of(rounded(x), rounded(y)));
            if (places.size() == MOST_PLACES) {
                dropEverySecond();
            }
        }
        cycles++;
    }

    private void dropEverySecond() {
        for (int i = 0; i < MOST_PLACES / 2; i++) {
            places.set(i, places.get(2 * i));
        }
        places.subList(MOST_PLACES / 2, MOST_PLACES).clear();
        cyclesPerPlace *= 2;
    }

    private static double rounded(double metres) {
        return Math.round(metres * HUNDREDTHS) / HUNDREDTHS;
    }

    /** {@return the places, x and y in metres, evenly over the run} */
    List<List<Double>> places() {
        return List.copyOf(places);
    }
}

package org.robonewbie.studio.replay;

import java.util.ArrayList;
import java.util.List;

/** Trail across the pitch with at most 256 points; the sampling interval doubles whenever the limit is reached. */
final class Trail {

    private static final int MAX_PLACES = 256;
    private static final double HUNDREDTHS = 100;

    private final List<List<Double>> places = new ArrayList<>();
    private long cyclesPerPlace = 1;
    private long cycles;

    void add(double x, double y) {
        if (cycles % cyclesPerPlace == 0) {
            places.add(List.of(rounded(x), rounded(y)));
            if (places.size() == MAX_PLACES) {
                dropEverySecond();
            }
        }
        cycles++;
    }

    private void dropEverySecond() {
        for (int i = 0; i < MAX_PLACES / 2; i++) {
            places.set(i, places.get(2 * i));
        }
        places.subList(MAX_PLACES / 2, MAX_PLACES).clear();
        cyclesPerPlace *= 2;
    }

    private static double rounded(double metres) {
        return Math.round(metres * HUNDREDTHS) / HUNDREDTHS;
    }

    /** {@return points with x and y in metres, sampled at equal intervals} */
    List<List<Double>> places() {
        return List.copyOf(places);
    }
}

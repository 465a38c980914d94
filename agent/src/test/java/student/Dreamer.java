package student;

import java.util.function.BooleanSupplier;

/** A program that takes its time. */
public final class Dreamer {

    private Dreamer() {}

    /** Does nothing useful until something happens, ten seconds at most. */
    public static void dreamUntil(BooleanSupplier awake) {
        long end = System.nanoTime() + 10_000_000_000L;
        while (!awake.getAsBoolean() && System.nanoTime() < end) {
            Thread.onSpinWait();
        }
    }
}

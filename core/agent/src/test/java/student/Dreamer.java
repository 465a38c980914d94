package student;

import java.util.function.BooleanSupplier;

/** A program that takes its time. */
public final class Dreamer {

    private Dreamer() {}

    /** Does nothing useful while the time passes. */
    public static void dream(Runnable tick, int times) {
        for (int i = 0; i < times; i++) {
            tick.run();
        }
    }

    /** Goes on until the time has come. */
    public static void dreamUntil(BooleanSupplier end) {
        boolean over = false;
        while (!over) {
            over = end.getAsBoolean();
        }
    }
}

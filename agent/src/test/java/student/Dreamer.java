package student;

/** A program that takes its time. */
public final class Dreamer {

    private Dreamer() {}

    /** Does nothing useful while the time passes. */
    public static void dream(Runnable tick, int times) {
        for (int i = 0; i < times; i++) {
            tick.run();
        }
    }
}

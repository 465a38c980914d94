package org.robonewbie.agent.log;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * Reports mistakes of the robot's program, each place in it once, so that a mistake in each of 50 cycles per second stays
 * readable. A mistake never stops the robot.
 */
public final class Diagnostics {

    private final PrintStream out;
    private final Set<String> known = new HashSet<>();
    private final List<String> reported = new ArrayList<>();
    private double seconds;
    private final Set<String> serious = new HashSet<>();
    private Consumer<LogLine> listener = line -> {};

    /**
     * Creates a reporter.
     *
     * @param out where to, usually {@code System.err}
     */
    public Diagnostics(PrintStream out) {
        this.out = out;
    }

    /**
     * Sets the clock.
     *
     * @param seconds simulated time in seconds
     */
    public synchronized void setTime(double seconds) {
        this.seconds = seconds;
    }

    /**
     * Sets the listener for mistakes.
     *
     * @param listener called for each mistake that is reported from now on
     */
    public synchronized void setListener(Consumer<LogLine> listener) {
        this.listener = listener;
    }

    /**
     * Reports a mistake of the code that calls the framework just now.
     *
     * @param kind what tells this mistake from others at the same place, without values that change
     * @param text what happened, the value, and what to do
     */
    public void report(String kind, Supplier<String> text) {
        reportAt(StudentCode.place().orElse(""), kind, text);
    }

    /**
     * Reports a mistake at a known place.
     *
     * @param place file and line, or empty if it has no place in the program
     * @param kind what tells this mistake from others at the same place, without values that change
     * @param text what happened, the value, and what to do
     */
    public synchronized void reportAt(String place, String kind, Supplier<String> text) {
        if (known.add(kind + "@" + place)) {
            String where = place.isEmpty() ? "" : " (" + place + ")";
            String what = text.get() + where;
            String line = String.format(Locale.ROOT, "%.2f s: ", seconds) + what;
            reported.add(line);
            out.println(line);
            listener.accept(new LogLine(seconds, LogLevel.WARNING, what));
        }
    }

    /**
     * Reports a mistake after which the program cannot do what it was written for, such as a motion that does not exist.
     *
     * @param kind what tells this mistake from others at the same place, without values that change
     * @param text what happened, the value, and what to do
     */
    public synchronized void reportSerious(String kind, Supplier<String> text) {
        serious.add(kind);
        report(kind, text);
    }

    /**
     * Forgives mistakes that have been put right while the program runs, such as a file that can be read now.
     *
     * @param kind how the kinds of these mistakes begin
     */
    public synchronized void forgive(String kind) {
        serious.removeIf(each -> each.startsWith(kind));
    }

    /** {@return whether a mistake was reported, and not put right, that makes the run a failure} */
    public synchronized boolean isSerious() {
        return !serious.isEmpty();
    }

    /** {@return the reported lines, oldest first} */
    public synchronized List<String> reported() {
        return List.copyOf(reported);
    }
}

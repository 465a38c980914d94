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
 * Reports errors in a robot program, once for each line of the program, so that an error in every cycle does not flood
 * the output. An error never stops the robot.
 */
public final class Diagnostics {

    private final PrintStream out;
    private final Set<String> known = new HashSet<>();
    private final List<String> reported = new ArrayList<>();
    private double seconds;
    private final Set<String> serious = new HashSet<>();
    private Consumer<LogLine> listener = line -> {};

    /**
     * Creates diagnostics without reports.
     *
     * @param out output for the reports, usually {@code System.err}
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
     * Sets the listener for reports.
     *
     * @param listener called for each report from now on
     */
    public synchronized void setListener(Consumer<LogLine> listener) {
        this.listener = listener;
    }

    /**
     * Reports an error at the program line that is being executed.
     *
     * @param kind distinguishes this error from others on the same line; must not contain values that change
     * @param text what happened, the value that caused it, and what to do
     */
    public void report(String kind, Supplier<String> text) {
        reportAt(StudentCode.place().orElse(""), kind, text);
    }

    /**
     * Reports an error at a given line of the program.
     *
     * @param place file and line; empty if the error belongs to no line of the program
     * @param kind distinguishes this error from others on the same line; must not contain values that change
     * @param text what happened, the value that caused it, and what to do
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
     * Reports an error that makes the run a failure, such as a motion that does not exist.
     *
     * @param kind distinguishes this error from others on the same line; must not contain values that change
     * @param text what happened, the value that caused it, and what to do
     */
    public synchronized void reportSerious(String kind, Supplier<String> text) {
        serious.add(kind);
        report(kind, text);
    }

    /**
     * Clears serious errors that were fixed during the run, for example when a file has become readable again.
     *
     * @param kind prefix of the kinds to clear
     */
    public synchronized void forgive(String kind) {
        serious.removeIf(each -> each.startsWith(kind));
    }

    /** {@return whether a serious error was reported and not cleared} */
    public synchronized boolean isSerious() {
        return !serious.isEmpty();
    }

    /** {@return the reported lines, oldest first} */
    public synchronized List<String> reported() {
        return List.copyOf(reported);
    }
}

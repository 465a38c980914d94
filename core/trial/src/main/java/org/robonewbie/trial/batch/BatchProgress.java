package org.robonewbie.trial.batch;

import java.io.PrintStream;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.LongSupplier;

/**
 * Shows the progress of a batch in one line: a progress bar, the number of finished jobs, their rate and the remaining time. On
 * a terminal, the line is updated in place; elsewhere, a new line is printed once a minute.
 *
 * <pre>{@code
 * BatchProgress progress = BatchProgress.of("trials", 400, 0);
 * runner.run(seeds, job, (seed, result) -> progress.advance(result.failed()));
 * progress.close();
 * }</pre>
 */
public final class BatchProgress implements AutoCloseable {

    private static final double NANOSECONDS = 1e9;
    private static final double TERMINAL_INTERVAL_SECONDS = 0.2;
    private static final double LOG_INTERVAL_SECONDS = 60;
    private static final int BAR_LENGTH = 20;
    private static final int MAX_LINE = 79;

    private final String unit;
    private final int total;
    private final int known;
    private final boolean terminal;
    private final PrintStream out;
    private final LongSupplier nanoseconds;
    private final long start;
    private int done;
    private int failed;
    private double shownSeconds;
    private boolean visible;

    /**
     * Creates the progress display of a batch.
     *
     * @param unit what is counted, such as {@code trials}
     * @param total the number of jobs
     * @param known number of jobs finished by earlier runs
     * @param terminal whether the output is a terminal
     * @param out the output
     * @param nanoseconds a clock that returns nanoseconds
     */
    public BatchProgress(
            String unit, int total, int known, boolean terminal, PrintStream out, LongSupplier nanoseconds) {
        this.unit = unit;
        this.total = total;
        this.known = known;
        this.terminal = terminal;
        this.out = out;
        this.nanoseconds = nanoseconds;
        this.start = nanoseconds.getAsLong();
        this.done = known;
    }

    /**
     * Creates the progress display of a batch on standard error.
     *
     * @param unit what is counted, such as {@code trials}
     * @param total the number of jobs
     * @param known number of jobs finished by earlier runs
     * @return the progress display
     */
    @SuppressWarnings(
            "SystemConsoleNull") // System.console() is never null in Java 22 to 24, so logs are updated in place too
    public static BatchProgress of(String unit, int total, int known) {
        return new BatchProgress(unit, total, known, System.console() != null, System.err, System::nanoTime);
    }

    /**
     * Counts a finished job.
     *
     * @param hasFailed whether the job failed
     */
    public synchronized void advance(boolean hasFailed) {
        done++;
        failed += hasFailed ? 1 : 0;
        double now = seconds();
        if (now - shownSeconds >= (terminal ? TERMINAL_INTERVAL_SECONDS : LOG_INTERVAL_SECONDS)) {
            shownSeconds = now;
            show();
        }
    }

    /**
     * Prints a line to another output, above the progress line.
     *
     * @param output receives the line
     * @param line the text
     */
    public synchronized void print(Consumer<String> output, String line) {
        boolean wasVisible = visible;
        close();
        output.accept(line);
        if (wasVisible) {
            show();
        }
    }

    /** {@return the number of jobs per second in this run; 0 if none has finished} */
    public synchronized double rate() {
        return done == known ? 0 : (done - known) / Math.max(seconds(), 1 / NANOSECONDS);
    }

    /** {@return the estimated time until all jobs are finished, in seconds; 0 if unknown} */
    public synchronized double secondsLeft() {
        return done == known ? 0 : (total - done) / rate();
    }

    /** {@return the progress line, such as {@code [=====>    ] 12 of 40 trials, 3.4 per second, 0:08 left}} */
    public synchronized String line() {
        int filled = total == 0 ? BAR_LENGTH : (int) ((long) BAR_LENGTH * Math.min(done, total) / total);
        String bar = "=".repeat(filled) + (filled < BAR_LENGTH ? ">" + " ".repeat(BAR_LENGTH - filled - 1) : "");
        long left = (long) (secondsLeft() + 0.5);
        String pace = rate() >= 0.1
                ? String.format(Locale.ROOT, "%.1f per second", rate())
                : String.format(Locale.ROOT, "%.1f per minute", 60 * rate());
        return String.format(Locale.ROOT, "[%s] %d of %d %s, %s, %s left", bar, done, total, unit, pace, time(left))
                + (failed > 0 ? ", " + failed + " failed" : "");
    }

    private static String time(long seconds) {
        return seconds < 3600
                ? String.format(Locale.ROOT, "%d:%02d", seconds / 60, seconds % 60)
                : String.format(Locale.ROOT, "%d:%02d:%02d", seconds / 3600, seconds / 60 % 60, seconds % 60);
    }

    private void show() {
        if (terminal) {
            out.print("\r" + pad(line()));
            out.flush();
            visible = true;
        } else {
            out.println(line());
        }
    }

    /** Removes the progress line from the terminal. */
    @Override
    public synchronized void close() {
        if (visible) {
            out.print("\r" + pad("") + "\r");
            out.flush();
            visible = false;
        }
    }

    private double seconds() {
        return (nanoseconds.getAsLong() - start) / NANOSECONDS;
    }

    private static String pad(String line) {
        return line + " ".repeat(Math.max(0, MAX_LINE - line.length()));
    }
}

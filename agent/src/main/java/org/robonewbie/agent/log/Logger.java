package org.robonewbie.agent.log;

import java.io.PrintStream;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.IllegalFormatException;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;

/**
 * Collects what a robot has to say and prints it when the run is over, since printing within a cycle costs time that the
 * robot has not. Nothing is lost when the program or the server dies. May be used by several threads.
 *
 * <pre>{@code
 * log.info("ball at %.2f m", fieldView.ball().distance());
 * }</pre>
 */
public final class Logger {

    /** How many lines are kept in memory, the newest; older ones go to a file. */
    public static final int CAPACITY = 200_000;

    private static final int LINES_TO_FILE = 1000;

    private final String owner;
    private final int capacity;
    private final Deque<LogLine> lines = new ArrayDeque<>();
    private LogLevel level = LogLevel.INFO;
    private double seconds;
    private final Overflow overflow = new Overflow();
    private Consumer<LogLine> listener = line -> {};

    /**
     * Creates an empty log.
     *
     * @param owner whose log it is, for the headline
     */
    public Logger(String owner) {
        this(owner, CAPACITY);
    }

    Logger(String owner, int capacity) {
        this.owner = owner;
        this.capacity = capacity;
    }

    /**
     * Chooses what is worth to be kept.
     *
     * @param level the least important level that is kept, at first {@link LogLevel#INFO}
     */
    public synchronized void setLevel(LogLevel level) {
        this.level = level;
    }

    /**
     * Sets the clock of the log; the framework does this in each cycle.
     *
     * @param seconds simulated time in seconds
     */
    public synchronized void setTime(double seconds) {
        this.seconds = seconds;
    }

    /**
     * Lets somebody read along.
     *
     * @param listener takes each line that is kept from now on, at once and in the thread that writes it
     */
    public synchronized void setListener(Consumer<LogLine> listener) {
        this.listener = listener;
    }

    /**
     * Writes down a detail.
     *
     * @param format text; with values it is a pattern as of {@link String#format}, without values it stays as it is
     * @param values what the pattern shows
     */
    public void debug(String format, Object... values) {
        log(LogLevel.DEBUG, format, values);
    }

    /**
     * Writes down what happens.
     *
     * @param format text; with values it is a pattern as of {@link String#format}, without values it stays as it is
     * @param values what the pattern shows
     */
    public void info(String format, Object... values) {
        log(LogLevel.INFO, format, values);
    }

    /**
     * Writes down something odd.
     *
     * @param format text; with values it is a pattern as of {@link String#format}, without values it stays as it is
     * @param values what the pattern shows
     */
    public void warning(String format, Object... values) {
        log(LogLevel.WARNING, format, values);
    }

    /**
     * Writes down something wrong.
     *
     * @param format text; with values it is a pattern as of {@link String#format}, without values it stays as it is
     * @param values what the pattern shows
     */
    public void error(String format, Object... values) {
        log(LogLevel.ERROR, format, values);
    }

    /**
     * Takes a look at what is kept.
     *
     * @return the lines, oldest first
     */
    public synchronized List<LogLine> lines() {
        return List.copyOf(lines);
    }

    /**
     * Prints what has come in since the last call, and forgets it.
     *
     * @param out where to
     */
    public synchronized void print(PrintStream out) {
        if (lines.isEmpty()) {
            return;
        }
        StringBuilder all = new StringBuilder("--- log of " + owner + " ---\n");
        all.append(overflow.note());
        lines.forEach(line -> all.append(line).append('\n'));
        out.print(all.append("--- end of the log ---\n"));
        out.flush();
        lines.clear();
        overflow.forget();
    }

    private synchronized void log(LogLevel importance, String format, Object[] values) {
        if (importance.compareTo(level) < 0) {
            return;
        }
        if (lines.size() == capacity) {
            overflow.take(lines, Math.min(capacity, LINES_TO_FILE));
        }
        LogLine line = new LogLine(seconds, importance, text(format, values));
        lines.addLast(line);
        listener.accept(line);
    }

    /** A wrong pattern must not stop a robot: then pattern and values are written as they are. */
    private static String text(String format, Object[] values) {
        if (values.length == 0) {
            return format;
        }
        try {
            return String.format(Locale.ROOT, format, values);
        } catch (IllegalFormatException wrongPattern) {
            return format + " " + java.util.Arrays.toString(values);
        }
    }
}

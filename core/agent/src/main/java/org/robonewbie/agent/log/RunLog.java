package org.robonewbie.agent.log;

import java.io.PrintStream;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.Supplier;

/** The log of one robot in one run, including the methods that only the framework uses. */
public final class RunLog implements Logger {

    /** Maximum number of lines in memory; older lines are moved to the overflow. */
    public static final int CAPACITY = 200_000;

    private static final int LINES_TO_MOVE = 1000;

    private final String owner;
    private final int capacity;
    private final Deque<LogLine> lines = new ArrayDeque<>();
    private LogOverflow overflow = new DroppedLines();
    private volatile LogLevel level = LogLevel.INFO;
    private double seconds;
    private Consumer<LogLine> listener = line -> {};
    private volatile Consumer<Supplier<String>> patternListener = advice -> {};

    /**
     * Creates an empty log.
     *
     * @param owner name of the robot, for the heading
     */
    public RunLog(String owner) {
        this(owner, CAPACITY);
    }

    RunLog(String owner, int capacity) {
        this.owner = owner;
        this.capacity = capacity;
    }

    @Override
    public void setLevel(LogLevel level) {
        this.level = level;
    }

    /**
     * Sets the clock of the log.
     *
     * @param seconds simulated time in seconds
     */
    public synchronized void setTime(double seconds) {
        this.seconds = seconds;
    }

    /**
     * Sets the listener for log lines.
     *
     * @param listener called immediately, in the logging thread
     */
    public synchronized void setListener(Consumer<LogLine> listener) {
        this.listener = listener;
    }

    /**
     * Sets the listener for patterns that do not match their values.
     *
     * @param listener called with a description of the error, in the logging thread
     */
    public void setPatternListener(Consumer<Supplier<String>> listener) {
        patternListener = listener;
    }

    /**
     * Sets the overflow for lines that no longer fit into memory; by default they are dropped.
     *
     * @param overflow takes the oldest lines
     */
    public synchronized void setOverflow(LogOverflow overflow) {
        this.overflow = overflow;
    }

    @Override
    public void debug(String format, Object... values) {
        log(LogLevel.DEBUG, format, values);
    }

    @Override
    public void info(String format, Object... values) {
        log(LogLevel.INFO, format, values);
    }

    @Override
    public void warning(String format, Object... values) {
        log(LogLevel.WARNING, format, values);
    }

    @Override
    public void error(String format, Object... values) {
        log(LogLevel.ERROR, format, values);
    }

    @Override
    public synchronized List<LogLine> lines() {
        return List.copyOf(lines);
    }

    /**
     * Prints and clears the log.
     *
     * @param out the output
     */
    public synchronized void print(PrintStream out) {
        if (lines.isEmpty()) {
            return;
        }
        StringBuilder all = new StringBuilder("--- log of " + owner + " ---\n");
        all.append(overflow.closingNote());
        lines.forEach(line -> all.append(line).append('\n'));
        out.print(all.append("--- end of the log ---\n"));
        out.flush();
        lines.clear();
    }

    private void log(LogLevel importance, String format, Object[] values) {
        if (importance.compareTo(level) >= 0) {
            append(importance, NegativeZeroFormat.removed(text(format, values)));
        }
    }

    private synchronized void append(LogLevel importance, String text) {
        if (lines.size() == capacity) {
            moveOldest(Math.min(capacity, LINES_TO_MOVE));
        }
        LogLine line = new LogLine(seconds, importance, text);
        lines.addLast(line);
        listener.accept(line);
    }

    private void moveOldest(int count) {
        overflow.take(lines.stream().limit(count).toList());
        for (int i = 0; i < count; i++) {
            lines.removeFirst();
        }
    }

    /** Formats a line. An invalid pattern must not stop a robot; it is logged unformatted with its values. */
    private String text(String format, Object[] values) {
        if (values.length == 0) {
            return format;
        }
        try {
            String text = String.format(Locale.ROOT, format, values);
            if (!PatternAdvice.leavesValuesOut(format, values)) {
                return text;
            }
        } catch (IllegalArgumentException wrongPattern) {
            // handled below, like a pattern with surplus values
        }
        patternListener.accept(() -> PatternAdvice.of(format, values));
        return format + " " + Arrays.toString(values);
    }

    private static final class DroppedLines implements LogOverflow {

        private long count;

        @Override
        public void take(List<LogLine> oldest) {
            count += oldest.size();
        }

        @Override
        public String closingNote() {
            String note = count == 0 ? "" : "(the first " + count + " lines were dropped)\n";
            count = 0;
            return note;
        }
    }
}

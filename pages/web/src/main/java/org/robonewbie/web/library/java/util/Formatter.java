package org.robonewbie.web.library.java.util;

import java.io.Closeable;
import java.io.Flushable;
import java.io.IOException;
import java.util.Locale;
import org.jspecify.annotations.Nullable;

/**
 * Subset of {@link java.util.Formatter} for the page: all conversions except dates, with numbers as in {@link
 * Locale#ROOT}. It is needed because in TeaVM 0.15.0, {@code %%} consumes an argument and 12.5 is rounded to 12.
 */
public final class Formatter implements Closeable, Flushable {

    private static final int SAME_AGAIN = -1;

    private final Appendable destination;
    private @Nullable IOException failure;

    /** Creates a formatter that writes to a string. */
    public Formatter() {
        this(new StringBuilder());
    }

    /**
     * Creates a formatter that writes to a string.
     *
     * @param locale ignored
     */
    public Formatter(@Nullable Locale locale) {
        this();
    }

    /**
     * Creates a formatter that writes to a destination.
     *
     * @param destination receives the text
     */
    public Formatter(Appendable destination) {
        this.destination = destination;
    }

    /**
     * Creates a formatter that writes to a destination.
     *
     * @param destination receives the text
     * @param locale ignored
     */
    public Formatter(Appendable destination, @Nullable Locale locale) {
        this(destination);
    }

    /**
     * Writes a formatted string.
     *
     * @param locale ignored
     * @param format a string with specifiers such as {@code %.2f}
     * @param arguments the values
     * @return this formatter
     */
    public Formatter format(@Nullable Locale locale, String format, @Nullable Object... arguments) {
        return format(format, arguments);
    }

    /**
     * Writes a formatted string.
     *
     * @param format a string with specifiers such as {@code %.2f}
     * @param arguments the values
     * @return this formatter
     * @throws IllegalArgumentException if the format and the values do not match
     */
    public Formatter format(String format, @Nullable Object... arguments) {
        int next = 0;
        int last = -1;
        int at = 0;
        for (int percent = format.indexOf('%'); percent >= 0; percent = format.indexOf('%', at)) {
            write(format.substring(at, percent));
            FormatSpecifier specifier = FormatSpecifier.read(format, percent + 1);
            at = specifier.end();
            if (specifier.isText()) {
                write(specifier.text());
            } else {
                if (specifier.index() > 0) {
                    last = specifier.index() - 1;
                } else if (specifier.index() != SAME_AGAIN) {
                    last = next++;
                }
                write(specifier.text(argument(arguments, last, format.substring(percent, at))));
            }
        }
        write(format.substring(at));
        return this;
    }

    private static @Nullable Object argument(@Nullable Object[] arguments, int number, String specifier) {
        if (number < 0 || number >= arguments.length) {
            throw new IllegalArgumentException("Format specifier '" + specifier + "'");
        }
        return arguments[number];
    }

    private void write(String text) {
        try {
            destination.append(text);
        } catch (IOException refused) {
            failure = refused;
        }
    }

    /** {@return the last exception of the destination, or null} */
    public @Nullable IOException ioException() {
        return failure;
    }

    /** {@return the destination} */
    public Appendable out() {
        return destination;
    }

    @Override
    public void flush() {}

    @Override
    public void close() {}

    @Override
    public String toString() {
        return destination.toString();
    }
}

package org.robonewbie.web.library.java.util;

import java.io.Closeable;
import java.io.Flushable;
import java.io.IOException;
import java.util.Locale;
import org.jspecify.annotations.Nullable;

/**
 * What the page needs of {@link java.util.Formatter}: all conversions but those of dates, with numbers written as in {@link
 * Locale#ROOT}. In the one of TeaVM 0.15.0 {@code %%} takes an argument away, and 12.5 is rounded to 12.
 */
public final class Formatter implements Closeable, Flushable {

    private static final int SAME_AGAIN = -1;

    private final Appendable destination;
    private @Nullable IOException failure;

    /** Writes into memory. */
    public Formatter() {
        this(new StringBuilder());
    }

    /**
     * Writes into memory.
     *
     * @param locale without a meaning here
     */
    public Formatter(@Nullable Locale locale) {
        this();
    }

    /**
     * Writes to a destination.
     *
     * @param destination gets the texts
     */
    public Formatter(Appendable destination) {
        this.destination = destination;
    }

    /**
     * Writes to a destination.
     *
     * @param destination gets the texts
     * @param locale without a meaning here
     */
    public Formatter(Appendable destination, @Nullable Locale locale) {
        this(destination);
    }

    /**
     * Writes a text with values.
     *
     * @param locale without a meaning here
     * @param format a text with specifiers such as {@code %.2f}
     * @param arguments the values
     * @return this formatter
     */
    public Formatter format(@Nullable Locale locale, String format, @Nullable Object... arguments) {
        return format(format, arguments);
    }

    /**
     * Writes a text with values.
     *
     * @param format a text with specifiers such as {@code %.2f}
     * @param arguments the values
     * @return this formatter
     * @throws IllegalArgumentException with Java's own words, if format and values do not fit
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

    /** {@return where the texts go} */
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

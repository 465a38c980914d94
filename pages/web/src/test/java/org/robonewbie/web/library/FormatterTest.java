package org.robonewbie.web.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.catchThrowable;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.web.library.java.util.Formatter;

/** Formatting in the page gives the same results as in Java. */
class FormatterTest {

    private static final int MANY = 20_000;

    @ParameterizedTest
    @ValueSource(
            strings = {
                "%.0f", "%.1f", "%.2f", "%.3f", "%f", "%8.2f", "%-8.2f|", "%08.1f", "%+.2f", "% .1f", "%,.2f", "%(.1f",
                        "%e",
                "%.3e", "%E", "%.0e", "%g", "%.4g", "%.6g", "%G", "%s", "%S", "%.3s", "%6.2s|", "%b", "%h"
            })
    void realNumberIsWrittenAsInJava(String format) {
        List<Double> numbers = new ArrayList<>(List.of(
                0.0,
                -0.0,
                0.5,
                1.5,
                2.5,
                12.5,
                0.05,
                0.15,
                0.25,
                0.005,
                0.995,
                9.5,
                99.5,
                9.995,
                1e-4,
                9.9999e-5,
                1e-5,
                1e6,
                999999.5,
                123456789.0,
                1e10,
                1e22,
                1e-300,
                1e300,
                100.0,
                1000.0));
        numbers.addAll(List.of(Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY));
        Random random = new Random(1);
        for (int i = 0; i < MANY; i++) {
            numbers.add(random.nextGaussian() * (i % 3 == 0 ? 1000 : 2));
        }

        for (Double number : numbers) {
            assertSame(format, number);
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "%d", "%5d", "%-5d|", "%05d", "%+d", "% d", "%,d", "%(d", "%x", "%X", "%02x", "%#x", "%o", "%#o", "%s",
                "%h"
            })
    void wholeNumberIsWrittenAsInJava(String format) {
        for (long number : new long[] {0, 1, -1, 7, 10, 999, 1000, -1234567, Integer.MAX_VALUE, Integer.MIN_VALUE}) {
            assertSame(format, number);
            assertSame(format, (int) number);
            assertSame(format, (short) number);
            assertSame(format, (byte) number);
        }
    }

    @Test
    void valuesAreTakenInTheirOrder() {
        assertSame("head at %.0f %% of the time, %s, %n %c%C", 99.5, "well", 'a', 'b');
        assertSame("%2$s %1$s %s %<s %s", "a", "b");
        assertSame("%5%|%-5%|");
        assertSame("nothing", "too much");
        assertSame("%s %b %d %.1f %c", null, null, null, null, null);
        assertSame("%b %B %c", true, "something", 65);
    }

    @Test
    void localeChangesNothing() {
        assertThat(new Formatter(Locale.GERMAN).format("%.2f", 1.5).toString()).isEqualTo("1.50");
        assertThat(new Formatter().format(Locale.GERMAN, "%.2f", 1.5).toString())
                .isEqualTo("1.50");
    }

    @ParameterizedTest
    @ValueSource(strings = {"%d", "%x", "%c", "%q", "%", "%s %s", "%3$s", "%<s"})
    void formatErrorsAreThoseOfJava(String format) {
        Throwable there = catchThrowable(() -> String.format(Locale.ROOT, format, 1.5));

        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Formatter().format(format, 1.5))
                .withMessage(there.getMessage());
    }

    private static void assertSame(String format, @Nullable Object... values) {
        assertThat(new Formatter().format(format, values).toString())
                .isEqualTo(String.format(Locale.ROOT, format, values));
    }
}

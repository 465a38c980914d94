package org.robonewbie.protocol.sexp;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Scale;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.protocol.frame.MessageBuffer;

class SexpNumberReadingTest {

    @ParameterizedTest
    @CsvSource({
        "0, 0",
        "-0.00, -0.0",
        "+2.5, 2.5",
        "1e3, 1000",
        "1.2E-3, 0.0012",
        ".5, 0.5",
        "-.5, -0.5",
        "5., 5",
        "12abc, 12",
        "1.5.5, 1.5",
        "1e, 1",
        "1e+, 1",
        "2e1x, 20",
        "1e400, Infinity",
        "-1e400, -Infinity",
        "1e-400, 0",
        "inf, Infinity",
        "-INF, -Infinity",
        "nan, NaN",
        "-nan, NaN",
        "00000000000000000000000012.5, 12.5",
        "1e99999999999999999999, Infinity"
    })
    void understandsWhatTheCLibraryUnderstands(String text, Double expected) {
        SexpReader reader = readerOf(text);

        assertThat(reader.number()).isEqualTo(expected);
        assertThat(reader.isNumber()).isTrue();
    }

    @ParameterizedTest
    @ValueSource(strings = {"abc", "-", "+", ".", "-.", "e5", "--1", ".nan", "na", "i"})
    void countsTextThatIsNoNumberAsZero(String text) {
        SexpReader reader = readerOf(text);

        assertThat(reader.number()).isZero();
        assertThat(reader.isNumber()).isFalse();
    }

    @ParameterizedTest
    @CsvSource({"3.99, 3", "-3.99, -3", "1e99, 2147483647", "nan, 0", "abc, 0"})
    void cutsWholeNumbersOff(String text, int expected) {
        assertThat(readerOf(text).integer()).isEqualTo(expected);
    }

    @Property
    void readsEveryDoubleAsItWasWritten(@ForAll double value) {
        assertThat(readerOf(Double.toString(value)).number()).isEqualTo(value);
    }

    @Property
    void readsDecimalsCorrectlyRounded(@ForAll @Scale(30) BigDecimal value) {
        String text = value.toPlainString();

        assertThat(readerOf(text).number()).isEqualTo(Double.parseDouble(text));
    }

    @Property
    void readsEverydayNumbersCorrectlyRounded(
            @ForAll @IntRange(min = -1_000_000, max = 1_000_000) int mantissa,
            @ForAll @IntRange(max = 9) int decimals) {
        String text = BigDecimal.valueOf(mantissa, decimals).toPlainString();

        assertThat(readerOf(text).number()).isEqualTo(Double.parseDouble(text));
    }

    private static SexpReader readerOf(String atom) {
        MessageBuffer message = new MessageBuffer();
        message.append(atom);
        SexpReader reader = new SexpReader();
        reader.start(message);
        reader.next();
        return reader;
    }
}

package org.robonewbie.protocol.sexp;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.protocol.frame.MessageBuffer;

class SexpWriterTest {

    @ParameterizedTest
    @CsvSource({
        "93.6, 93.60",
        "-0.001, -0.00",
        "-0.0, -0.00",
        "0, 0.00",
        "0.125, 0.12",
        "0.375, 0.38",
        "-0.125, -0.12",
        "1.005, 1.00",
        "2.675, 2.67",
        "99.999, 100.00",
        "1e20, 100000000000000000000.00",
        "NaN, nan",
        "Infinity, inf",
        "-Infinity, -inf",
        "4.9E-324, 0.00",
        "70368744177664.126, 70368744177664.12"
    })
    void writesTwoDecimalsAsAStreamDoes(double value, String expected) {
        assertThat(fixed(value, 2)).isEqualTo(expected);
    }

    @Property
    void roundsToTheNearestDecimalOfTheExactValue(@ForAll double value, @ForAll @IntRange(max = 12) int decimals) {
        assertThat(fixed(value, decimals)).isEqualTo(expectedFixed(value, decimals));
    }

    @Property
    void roundsToTheNumberThatAReaderGets(@ForAll double value, @ForAll @IntRange(max = 12) int decimals) {
        assertThat(SexpWriter.rounded(value, decimals)).isEqualTo(Double.parseDouble(fixed(value, decimals)));
    }

    @Property
    void roundsEverydayValuesToTheNumberThatAReaderGets(@ForAll @DoubleRange(min = -400, max = 400) double value) {
        assertThat(SexpWriter.rounded(value, 2)).isEqualTo(Double.parseDouble(fixed(value, 2)));
        assertThat(SexpWriter.rounded(value, 9)).isEqualTo(Double.parseDouble(fixed(value, 9)));
    }

    @Property
    void roundsEverydayValuesExactly(@ForAll @DoubleRange(min = -400, max = 400) double value) {
        assertThat(fixed(value, 2)).isEqualTo(expectedFixed(value, 2));
    }

    @Property
    void roundsNeighboursOfTiesExactly(
            @ForAll @IntRange(max = 100_000_000) int tick, @ForAll @IntRange(min = -2, max = 2) int neighbour) {
        double value = (tick + 0.5) / 100;
        for (int i = 0; i < Math.abs(neighbour); i++) {
            value = neighbour < 0 ? Math.nextDown(value) : Math.nextUp(value);
        }

        assertThat(fixed(value, 2)).isEqualTo(expectedFixed(value, 2));
    }

    @ParameterizedTest
    @CsvSource({
        "2.5, 2.5",
        "3, 3",
        "-0.5, -0.5",
        "6.13954, 6.13954",
        "100, 100",
        "0, 0",
        "-0.0, -0",
        "1e-10, 0",
        "0.000000001, 0.000000001",
        "NaN, nan"
    })
    void leavesZerosAtTheEndOut(double value, String expected) {
        MessageBuffer message = new MessageBuffer();

        new SexpWriter(message).decimal(value, 9);

        assertThat(message).hasToString(expected);
    }

    @ParameterizedTest
    @CsvSource({
        "-8.7422776573475858e-08, -8.74228e-08",
        "0.03646277, 0.0364628",
        "1, 1",
        "-1, -1",
        "0, 0",
        "-0.0, -0",
        "0.1, 0.1",
        "100000, 100000",
        "999999.4, 999999",
        "999999.5, 1e+06",
        "1234567, 1.23457e+06",
        "0.0001, 0.0001",
        "0.00001, 1e-05",
        "0.000099999996, 0.0001",
        "1.91069e-15, 1.91069e-15",
        "1e100, 1e+100",
        "1e-100, 1e-100",
        "NaN, nan",
        "Infinity, inf",
        "-Infinity, -inf",
        "15.3, 15.3",
        "30, 30",
        "1e22, 1e+22",
        "9.9999951, 10"
    })
    void writesSixDigitsAsAStreamDoes(double value, String expected) {
        assertThat(general(value)).isEqualTo(expected);
    }

    @Property
    void writesSixDigitsOfTheExactValue(@ForAll double value) {
        assertThat(general(value)).isEqualTo(expectedGeneral(value));
    }

    @Property
    void writesSixDigitsOfSmallValues(@ForAll float mantissa, @ForAll @IntRange(min = -25, max = 10) int exponent) {
        double value = mantissa * Math.pow(10, exponent);

        assertThat(general(value)).isEqualTo(expectedGeneral(value));
    }

    @Property
    void writesWholeNumbers(@ForAll long value) {
        MessageBuffer message = new MessageBuffer();

        new SexpWriter(message).integer(value);

        assertThat(message).hasToString(Long.toString(value));
    }

    @Test
    void writesTheSmallestWholeNumber() {
        MessageBuffer message = new MessageBuffer();

        new SexpWriter(message).integer(Long.MIN_VALUE);

        assertThat(message).hasToString("-9223372036854775808");
    }

    @Test
    void appendsToWhatIsThere() {
        MessageBuffer message = new MessageBuffer();
        message.append("(syn)");

        int length = new SexpWriter(message)
                .text("(beam ")
                .fixed(-1, 1)
                .text(" ")
                .integer(0)
                .text(")")
                .length();

        assertThat(message).hasToString("(syn)(beam -1.0 0)");
        assertThat(length).isEqualTo(18);
    }

    private static String fixed(double value, int decimals) {
        MessageBuffer message = new MessageBuffer();
        new SexpWriter(message).fixed(value, decimals);
        return message.toString();
    }

    private static String general(double value) {
        MessageBuffer message = new MessageBuffer();
        new SexpWriter(message).general(value);
        return message.toString();
    }

    private static String expectedFixed(double value, int decimals) {
        String sign = Double.doubleToRawLongBits(value) < 0 ? "-" : "";
        return sign
                + new BigDecimal(value)
                        .abs()
                        .setScale(decimals, RoundingMode.HALF_EVEN)
                        .toPlainString();
    }

    /** The rule of C's printf for %g, with six digits. */
    private static String expectedGeneral(double value) {
        String sign = Double.doubleToRawLongBits(value) < 0 ? "-" : "";
        if (value == 0) {
            return sign + "0";
        }
        BigDecimal rounded = new BigDecimal(value).abs().round(new MathContext(6, RoundingMode.HALF_EVEN));
        int exponent = rounded.precision() - rounded.scale() - 1;
        if (exponent >= -4 && exponent < 6) {
            return sign + rounded.stripTrailingZeros().toPlainString();
        }
        String mantissa = rounded.movePointLeft(exponent).stripTrailingZeros().toPlainString();
        return sign + mantissa + "e" + (exponent < 0 ? "-" : "+") + (Math.abs(exponent) < 10 ? "0" : "")
                + Math.abs(exponent);
    }
}

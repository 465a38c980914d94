package org.robonewbie.protocol.sexp;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.protocol.frame.MessageBuffer;

/**
 * Formats words and numbers byte for byte like SimSpark's C++ streams, without allocations for common numbers.
 *
 * <p>Numbers are rounded correctly from their exact binary value; ties are rounded to even. A negative number that rounds to
 * zero keeps its sign ({@code -0.00}).
 *
 * <pre>{@code
 * new SexpWriter(message).text("(HJ (n hj1) (ax ").fixed(angle, 2).text("))");
 * }</pre>
 */
public final class SexpWriter {

    private static final int GENERAL_DIGITS = 6;
    private static final double MAX_SCALED = 1L << 51;
    /** Distance from a tie above which floating-point arithmetic is certain to round correctly. */
    private static final double TIE_MARGIN = 1e-3;

    private static final double LARGEST_WITH_SAFE_MARGIN = 1L << 42;
    private final MessageBuffer message;

    /**
     * Creates a writer.
     *
     * @param message the buffer to which everything is appended
     */
    public SexpWriter(MessageBuffer message) {
        this.message = message;
    }

    /** {@return the current length of the buffer in bytes} */
    public int length() {
        return message.length();
    }

    /**
     * Writes text unchanged, including parentheses and spaces.
     *
     * @param ascii the text in ASCII
     * @return this writer
     */
    public SexpWriter text(String ascii) {
        message.append(ascii);
        return this;
    }

    /**
     * Writes an integer.
     *
     * @param value the number
     * @return this writer
     */
    public SexpWriter integer(long value) {
        if (value == Long.MIN_VALUE) {
            return text(Long.toString(value));
        }
        if (value < 0) {
            message.append((byte) '-');
        }
        appendDigits(Math.abs(value), 1);
        return this;
    }

    /**
     * Writes a number with a fixed number of decimal places, like C's {@code %.2f}.
     *
     * @param value the number; {@code nan} and {@code inf} are written as such
     * @param decimals digits after the decimal point, 0 to 22
     * @return this writer
     */
    public SexpWriter fixed(double value, int decimals) {
        if (writeSpecial(value)) {
            return this;
        }
        double magnitude = Math.abs(value);
        double scaled = magnitude * PowersOfTen.get(decimals);
        if (scaled >= MAX_SCALED) {
            return text(new BigDecimal(magnitude)
                    .setScale(decimals, RoundingMode.HALF_EVEN)
                    .toPlainString());
        }
        long rounded = roundProduct(magnitude, decimals, scaled);
        appendFixed(rounded, decimals);
        return this;
    }

    /**
     * Rounds a number as {@link #fixed} and {@link #decimal} do.
     *
     * @param value the number
     * @param decimals digits after the decimal point, 0 to 22
     * @return the number that a reader of the message receives
     */
    public static double rounded(double value, int decimals) {
        double magnitude = Math.abs(value);
        double scaled = magnitude * PowersOfTen.get(decimals);
        if (!(scaled < MAX_SCALED)) {
            return Double.isFinite(value)
                    ? new BigDecimal(value)
                            .setScale(decimals, RoundingMode.HALF_EVEN)
                            .doubleValue()
                    : value;
        }
        return Math.copySign(roundProduct(magnitude, decimals, scaled) / PowersOfTen.get(decimals), value);
    }

    /**
     * Writes a number with a maximum number of decimal places and no trailing zeros, never with an exponent.
     *
     * @param value the number; {@code nan} and {@code inf} are written as such
     * @param decimals maximum number of digits after the decimal point, 0 to 22
     * @return this writer
     */
    public SexpWriter decimal(double value, int decimals) {
        int start = message.length();
        fixed(value, decimals);
        if (decimals > 0 && Double.isFinite(value)) {
            stripZeros(start);
        }
        return this;
    }

    /**
     * Writes a number in the default format of C++ streams, like C's {@code %g}: six significant digits, no trailing zeros, an
     * exponent for very large and very small numbers ({@code -8.74228e-08}). Monitor messages use this format.
     *
     * @param value the number; {@code nan} and {@code inf} are written as such
     * @return this writer
     */
    public SexpWriter general(double value) {
        if (writeSpecial(value)) {
            return this;
        }
        double magnitude = Math.abs(value);
        if (magnitude == 0) {
            message.append((byte) '0');
            return this;
        }
        int exponent = (int) Math.floor(PortableMath.log10(magnitude));
        if (magnitude < 1e-15 || magnitude >= 1e22) {
            return generalSlowly(magnitude);
        }
        long mantissa = significantDigits(magnitude, exponent);
        if (mantissa < 100_000) {
            exponent--;
            mantissa = significantDigits(magnitude, exponent);
        }
        if (mantissa >= 1_000_000) {
            exponent++;
            mantissa = significantDigits(magnitude, exponent);
        }
        appendGeneral(mantissa, exponent);
        return this;
    }

    private boolean writeSpecial(double value) {
        if (Double.isNaN(value)) {
            message.append("nan");
            return true;
        }
        if (Double.doubleToRawLongBits(value) < 0) {
            message.append((byte) '-');
        }
        if (Double.isInfinite(value)) {
            message.append("inf");
            return true;
        }
        return false;
    }

    /** Rounds magnitude * 10^power to an integer. Near a tie, the exact product decides. */
    private static long roundProduct(double magnitude, int power, double scaled) {
        long below = (long) scaled;
        double aboveTie = scaled - (below + 0.5);
        if (Math.abs(aboveTie) < TIE_MARGIN || scaled > LARGEST_WITH_SAFE_MARGIN) {
            aboveTie = exactProductMinus(magnitude, PowersOfTen.get(power), below + 0.5);
        }
        return roundUp(below, aboveTie) ? below + 1 : below;
    }

    /** Rounds magnitude / 10^power to an integer. */
    private static long roundQuotient(double magnitude, int power) {
        double scaled = magnitude / PowersOfTen.get(power);
        long below = (long) scaled;
        double aboveTie = scaled - (below + 0.5);
        if (Math.abs(aboveTie) < TIE_MARGIN) {
            aboveTie = -exactProductMinus(below + 0.5, PowersOfTen.get(power), magnitude);
        }
        return roundUp(below, aboveTie) ? below + 1 : below;
    }

    /** Returns a * b - c without intermediate rounding, for a c close to the product. */
    private static double exactProductMinus(double a, double b, double c) {
        return (a * b - c) + PortableMath.productError(a, b);
    }

    private static boolean roundUp(long below, double aboveTie) {
        return aboveTie > 0 || (aboveTie == 0 && (below & 1) == 1);
    }

    private static long significantDigits(double magnitude, int exponent) {
        int power = GENERAL_DIGITS - 1 - exponent;
        return power >= 0
                ? roundProduct(magnitude, power, magnitude * PowersOfTen.get(power))
                : roundQuotient(magnitude, -power);
    }

    private SexpWriter generalSlowly(double magnitude) {
        BigDecimal rounded = new BigDecimal(magnitude).round(new MathContext(GENERAL_DIGITS, RoundingMode.HALF_EVEN));
        int exponent = rounded.precision() - rounded.scale() - 1;
        long mantissa = rounded.setScale(GENERAL_DIGITS - 1 - exponent, RoundingMode.UNNECESSARY)
                .unscaledValue()
                .longValueExact();
        appendGeneral(mantissa, exponent);
        return this;
    }

    private void appendGeneral(long mantissa, int exponent) {
        int start = message.length();
        if (exponent >= GENERAL_DIGITS || exponent < -4) {
            appendFixed(mantissa, GENERAL_DIGITS - 1);
            stripZeros(start);
            message.append((byte) 'e');
            message.append((byte) (exponent < 0 ? '-' : '+'));
            appendDigits(Math.abs(exponent), 2);
        } else {
            appendFixed(mantissa, GENERAL_DIGITS - 1 - exponent);
            if (exponent < GENERAL_DIGITS - 1) {
                stripZeros(start);
            }
        }
    }

    private void appendFixed(long value, int decimals) {
        appendDigits(value, decimals + 1);
        if (decimals > 0) {
            insertPoint(decimals);
        }
    }

    private void insertPoint(int decimals) {
        int length = message.length();
        message.resize(length + 1);
        byte[] bytes = message.bytes();
        System.arraycopy(bytes, length - decimals, bytes, length - decimals + 1, decimals);
        bytes[length - decimals] = '.';
    }

    private void appendDigits(long value, int atLeast) {
        int start = message.length();
        message.resize(start + Math.max(digits(value), atLeast));
        byte[] bytes = message.bytes();
        long rest = value;
        for (int i = message.length() - 1; i >= start; i--) {
            bytes[i] = (byte) ('0' + rest % 10);
            rest /= 10;
        }
    }

    private static int digits(long value) {
        int count = 0;
        for (long rest = value; rest != 0; rest /= 10) {
            count++;
        }
        return count;
    }

    private void stripZeros(int start) {
        byte[] bytes = message.bytes();
        int length = message.length();
        while (length > start + 1 && bytes[length - 1] == '0') {
            length--;
        }
        if (bytes[length - 1] == '.') {
            length--;
        }
        message.resize(length);
    }
}

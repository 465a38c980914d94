package org.robonewbie.web.library.java.util;

import java.util.IllegalFormatConversionException;
import java.util.Locale;
import java.util.UnknownFormatConversionException;
import org.jspecify.annotations.Nullable;

/**
 * Format specifier such as {@code %-8.2f}.
 *
 * @param index one-based index of the argument; 0 for the next argument, -1 for the previous one
 * @param flags the flags that are set, a subset of {@code -#+ 0,(}
 * @param width minimum number of characters
 * @param precision number of digits or characters; -1 if not given
 * @param conversion the conversion character
 * @param end index of the character after the specifier
 */
record FormatSpecifier(int index, String flags, int width, int precision, char conversion, int end) {

    private static final String FLAGS = "-#+ 0,(";
    private static final int DEFAULT_PRECISION = 6;
    private static final int GROUP_DIGITS = 3;

    /** Parses the specifier that begins with the percent sign just before a position. */
    static FormatSpecifier read(String format, int from) {
        int at = from;
        int index = 0;
        if (format.startsWith("<", at)) {
            index = -1;
            at++;
        } else if (format.startsWith("$", digitsEnd(format, at)) && digitsEnd(format, at) > at) {
            index = Integer.parseInt(format.substring(at, digitsEnd(format, at)));
            at = digitsEnd(format, at) + 1;
        }
        int flags = at;
        while (at < format.length() && FLAGS.indexOf(format.charAt(at)) >= 0) {
            at++;
        }
        int width = at;
        at = digitsEnd(format, at);
        int point = at;
        if (format.startsWith(".", at)) {
            at = digitsEnd(format, at + 1);
        }
        if (at >= format.length()) {
            throw new UnknownFormatConversionException("%");
        }
        return new FormatSpecifier(
                index,
                format.substring(flags, width),
                width == point ? 0 : Integer.parseInt(format.substring(width, point)),
                point == at ? -1 : Integer.parseInt(format.substring(point + 1, at)),
                format.charAt(at),
                at + 1);
    }

    private static int digitsEnd(String format, int from) {
        int at = from;
        while (at < format.length() && format.charAt(at) >= '0' && format.charAt(at) <= '9') {
            at++;
        }
        return at;
    }

    /** {@return whether it is {@code %%} or {@code %n}, which take no argument} */
    boolean isText() {
        return conversion == '%' || conversion == 'n';
    }

    /** {@return the text of {@code %%} or {@code %n}} */
    String text() {
        return conversion == '%' ? padded("%") : "\n";
    }

    /** Formats a value. */
    String text(@Nullable Object value) {
        String text = switch (Character.toLowerCase(conversion)) {
            case 'b' -> padded(cut(value instanceof Boolean known ? known.toString() : "" + (value != null)));
            case 's' -> padded(cut(String.valueOf(value)));
            case 'h' -> padded(cut(value == null ? "null" : Integer.toHexString(value.hashCode())));
            case 'c' -> padded(value == null ? "null" : character(value));
            case 'd', 'o', 'x' -> value == null ? padded("null") : whole(value);
            case 'e', 'f', 'g' -> value == null ? padded(cut("null")) : real(value);
            default -> throw new UnknownFormatConversionException(String.valueOf(conversion));
        };
        return Character.isUpperCase(conversion) ? text.toUpperCase(Locale.ROOT) : text;
    }

    private String character(Object value) {
        if (value instanceof Character letter) {
            return letter.toString();
        }
        if (value instanceof Integer || value instanceof Short || value instanceof Byte) {
            return new String(Character.toChars(((Number) value).intValue()));
        }
        throw new IllegalFormatConversionException(conversion, value.getClass());
    }

    private String whole(Object value) {
        boolean isWhole =
                value instanceof Integer || value instanceof Long || value instanceof Short || value instanceof Byte;
        if (!isWhole) {
            throw new IllegalFormatConversionException(conversion, value.getClass());
        }
        long number = ((Number) value).longValue();
        if (conversion == 'd') {
            String digits = Long.toString(number);
            return signed(number < 0, grouped(number < 0 ? digits.substring(1) : digits), true);
        }
        long bits = value instanceof Long ? number : number & mask(value);
        boolean isOctal = conversion == 'o';
        String prefix = has('#') ? (isOctal ? "0" : "0x") : "";
        return zeroPadded(prefix, isOctal ? Long.toOctalString(bits) : Long.toHexString(bits), "", true);
    }

    private static long mask(Object value) {
        return value instanceof Integer ? 0xffff_ffffL : value instanceof Short ? 0xffffL : 0xffL;
    }

    private String real(Object value) {
        if (!(value instanceof Double) && !(value instanceof Float)) {
            throw new IllegalFormatConversionException(conversion, value.getClass());
        }
        double number = ((Number) value).doubleValue();
        if (Double.isNaN(number)) {
            return padded("NaN");
        }
        boolean isNegative = Double.compare(number, 0) < 0;
        if (Double.isInfinite(number)) {
            return signed(isNegative, "Infinity", false);
        }
        Decimal decimal = Decimal.of(Math.abs(number));
        int digits = precision < 0 ? DEFAULT_PRECISION : precision;
        return signed(
                isNegative,
                switch (Character.toLowerCase(conversion)) {
                    case 'e' -> decimal.scientific(digits);
                    case 'f' -> grouped(decimal.fixed(digits));
                    default -> grouped(decimal.general(digits));
                },
                true);
    }

    /** Inserts grouping separators before the decimal point. */
    private String grouped(String digits) {
        if (!has(',') || digits.indexOf('e') >= 0) {
            return digits;
        }
        int point = digits.indexOf('.') < 0 ? digits.length() : digits.indexOf('.');
        StringBuilder text = new StringBuilder(digits);
        for (int at = point - GROUP_DIGITS; at > 0; at -= GROUP_DIGITS) {
            text.insert(at, ',');
        }
        return text.toString();
    }

    private String signed(boolean isNegative, String digits, boolean isNumber) {
        if (isNegative) {
            return has('(') ? zeroPadded("(", digits, ")", isNumber) : zeroPadded("-", digits, "", isNumber);
        }
        return zeroPadded(has('+') ? "+" : has(' ') ? " " : "", digits, "", isNumber);
    }

    private String zeroPadded(String before, String digits, String after, boolean isNumber) {
        int missing = has('0') && isNumber ? width - before.length() - digits.length() - after.length() : 0;
        return padded(before + "0".repeat(Math.max(0, missing)) + digits + after);
    }

    private String padded(String text) {
        String blanks = " ".repeat(Math.max(0, width - text.length()));
        return has('-') ? text + blanks : blanks + text;
    }

    private String cut(String text) {
        return precision < 0 || precision >= text.length() ? text : text.substring(0, precision);
    }

    private boolean has(char flag) {
        return flags.indexOf(flag) >= 0;
    }
}

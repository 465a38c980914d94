package org.robonewbie.protocol.sexp;

import java.nio.charset.StandardCharsets;

/**
 * Converts decimal text to the nearest double following the rules of C's {@code atof}, without allocations for common
 * numbers.
 *
 * <p>Mantissas up to 2^53 and powers of ten up to 10^22 are exact as doubles, so a single division of two such numbers
 * rounds correctly (Clinger 1990, "How to read floating point numbers accurately"). The JDK parses all other numbers.
 */
final class DecimalParser {

    private static final long MAX_EXACT_MANTISSA = 1L << 53;
    private static final int MAX_DIGITS = 18;

    private byte[] bytes = new byte[0];
    private int from;
    private int at;
    private int end;
    private long mantissa;
    private int significantDigits;

    /** Parses the longest prefix of the text that is a number. Returns 0 if there is none. */
    double parse(byte[] text, int first, int last) {
        start(text, first, last);
        boolean negative = skipSign();
        int digits = scanDigits();
        int decimals = 0;
        if (at < end && bytes[at] == '.') {
            at++;
            decimals = scanDigits();
            digits += decimals;
        }
        if (digits == 0) {
            return special();
        }
        if (hasExponent()
                || significantDigits > MAX_DIGITS
                || mantissa > MAX_EXACT_MANTISSA
                || decimals > PowersOfTen.MAX) {
            return parseSlowly();
        }
        double magnitude = mantissa / PowersOfTen.get(decimals);
        return negative ? -magnitude : magnitude;
    }

    /** Returns whether the text starts with a number, {@code nan} or {@code inf}. */
    boolean isNumber(byte[] text, int first, int last) {
        start(text, first, last);
        skipSign();
        if (at < end && bytes[at] == '.') {
            at++;
        }
        return (at < end && isDigit(bytes[at])) || special() != 0;
    }

    /** Returns whether the whole text is one decimal number such as {@code -1.5e-3}. */
    boolean isDecimal(byte[] text, int first, int last) {
        start(text, first, last);
        skipSign();
        int digits = scanDigits();
        if (at < end && bytes[at] == '.') {
            at++;
            digits += scanDigits();
        }
        hasExponent();
        return digits > 0 && at == end;
    }

    private void start(byte[] text, int first, int last) {
        bytes = text;
        from = first;
        at = first;
        end = last;
        mantissa = 0;
        significantDigits = 0;
    }

    private boolean skipSign() {
        if (at < end && (bytes[at] == '-' || bytes[at] == '+')) {
            at++;
            return bytes[at - 1] == '-';
        }
        return false;
    }

    private int scanDigits() {
        int firstDigit = at;
        while (at < end && isDigit(bytes[at])) {
            mantissa = 10 * mantissa + (bytes[at] - '0');
            if (mantissa != 0) {
                significantDigits++;
            }
            at++;
        }
        return at - firstDigit;
    }

    /** Skips the exponent if it is complete, and returns whether it is. */
    private boolean hasExponent() {
        if (at >= end || (bytes[at] != 'e' && bytes[at] != 'E')) {
            return false;
        }
        int mark = at;
        at++;
        skipSign();
        int firstDigit = at;
        while (at < end && isDigit(bytes[at])) {
            at++;
        }
        if (at > firstDigit) {
            return true;
        }
        at = mark;
        return false;
    }

    private double parseSlowly() {
        return Double.parseDouble(new String(bytes, from, at - from, StandardCharsets.US_ASCII));
    }

    private double special() {
        at = from;
        boolean negative = skipSign();
        if (startsWith("nan")) {
            return Double.NaN;
        }
        if (startsWith("inf")) {
            return negative ? Double.NEGATIVE_INFINITY : Double.POSITIVE_INFINITY;
        }
        return 0;
    }

    private boolean startsWith(String word) {
        if (end - at < word.length()) {
            return false;
        }
        for (int i = 0; i < word.length(); i++) {
            if ((bytes[at + i] | 0x20) != word.charAt(i)) {
                return false;
            }
        }
        return true;
    }

    private static boolean isDigit(byte character) {
        return character >= '0' && character <= '9';
    }
}

package org.robonewbie.web.library.java.util;

/**
 * Non-negative decimal number 0.DIGITS · 10^point, with half-up rounding as in Java.
 *
 * @param digits significant digits; empty for 0
 * @param point number of digits before the decimal point
 */
record Decimal(String digits, int point) {

    private static final int SMALLEST_FIXED = -4;

    /** {@return the shortest decimal number that uniquely identifies a double} */
    static Decimal of(double number) {
        String text = Double.toString(number);
        int e = text.indexOf('E');
        String mantissa = e < 0 ? text : text.substring(0, e);
        int exponent = e < 0 ? 0 : Integer.parseInt(text.substring(e + 1));
        int point = mantissa.indexOf('.');
        String all = mantissa.substring(0, point) + mantissa.substring(point + 1);
        int zeros = 0;
        while (zeros < all.length() && all.charAt(zeros) == '0') {
            zeros++;
        }
        return new Decimal(all.substring(zeros), point + exponent - zeros);
    }

    /** Rounds to the given number of significant digits. */
    private Decimal rounded(int count) {
        if (count >= digits.length()) {
            return this;
        }
        if (count < 0) {
            return new Decimal("", 0);
        }
        String kept = digits.substring(0, count);
        return digits.charAt(count) < '5' ? new Decimal(kept, point) : new Decimal(kept, point).oneMore();
    }

    private Decimal oneMore() {
        int nines = digits.length();
        while (nines > 0 && digits.charAt(nines - 1) == '9') {
            nines--;
        }
        if (nines == 0) {
            return new Decimal("1" + "0".repeat(digits.length()), point + 1);
        }
        char raised = (char) (digits.charAt(nines - 1) + 1);
        return new Decimal(digits.substring(0, nines - 1) + raised + "0".repeat(digits.length() - nines), point);
    }

    /** Formats in fixed-point notation with the given number of decimal places. */
    String fixed(int precision) {
        Decimal near = rounded(point + precision);
        if (near.digits.isEmpty()) {
            return withPoint("0", "0".repeat(precision));
        }
        String zerosBefore = "0".repeat(Math.max(0, 1 - near.point));
        String all = zerosBefore + near.digits;
        int before = Math.max(1, near.point);
        String padded = all + "0".repeat(Math.max(0, before + precision - all.length()));
        return withPoint(padded.substring(0, before), padded.substring(before, before + precision));
    }

    /** Formats in scientific notation with the given number of decimal places. */
    String scientific(int precision) {
        Decimal near = rounded(precision + 1);
        String all = near.digits + "0".repeat(Math.max(0, precision + 1 - near.digits.length()));
        int exponent = near.digits.isEmpty() ? 0 : near.point - 1;
        String power = Integer.toString(Math.abs(exponent));
        return withPoint(all.substring(0, 1), all.substring(1, precision + 1))
                + (exponent < 0 ? "e-" : "e+")
                + (power.length() < 2 ? "0" : "")
                + power;
    }

    /** Formats with the given number of significant digits, in scientific notation if the number is very large or small. */
    String general(int precision) {
        int count = Math.max(1, precision);
        Decimal near = rounded(count);
        if (digits.isEmpty()) {
            return fixed(count - 1);
        }
        boolean isUsual = near.point - 1 >= SMALLEST_FIXED && near.point <= count;
        return isUsual ? near.fixed(count - near.point) : scientific(count - 1);
    }

    private static String withPoint(String before, String behind) {
        return behind.isEmpty() ? before : before + "." + behind;
    }
}

package org.robonewbie.web.library.java.util;

/** What the simulator needs of {@link java.util.HexFormat}. */
public final class HexFormat {

    private static final HexFormat LOWER_CASE = new HexFormat();
    private static final String DIGITS = "0123456789abcdef";

    private HexFormat() {}

    /** {@return the format without separators, in small letters} */
    public static HexFormat of() {
        return LOWER_CASE;
    }

    /**
     * Writes bytes.
     *
     * @param bytes any
     * @return two digits for each
     */
    public String formatHex(byte[] bytes) {
        StringBuilder text = new StringBuilder();
        for (byte value : bytes) {
            text.append(DIGITS.charAt((value >> 4) & 0xf)).append(DIGITS.charAt(value & 0xf));
        }
        return text.toString();
    }
}

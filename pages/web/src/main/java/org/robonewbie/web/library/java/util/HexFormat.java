package org.robonewbie.web.library.java.util;

/** Subset of {@link java.util.HexFormat} for the simulator. */
public final class HexFormat {

    private static final HexFormat LOWER_CASE = new HexFormat();
    private static final String DIGITS = "0123456789abcdef";

    private HexFormat() {}

    /** {@return the lower-case format without separators} */
    public static HexFormat of() {
        return LOWER_CASE;
    }

    /**
     * Formats bytes.
     *
     * @param bytes the bytes
     * @return two digits per byte
     */
    public String formatHex(byte[] bytes) {
        StringBuilder text = new StringBuilder();
        for (byte value : bytes) {
            text.append(DIGITS.charAt((value >> 4) & 0xf)).append(DIGITS.charAt(value & 0xf));
        }
        return text.toString();
    }
}

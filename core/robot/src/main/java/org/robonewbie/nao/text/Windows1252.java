package org.robonewbie.nao.text;

/** Windows code page 1252: Latin-1 with printable characters in place of the control codes 0x80 to 0x9F. */
final class Windows1252 {

    private static final int FIRST = 0x80;

    /** The characters from 0x80 to 0x9F; {@code \0} where the code page has none. */
    private static final String SIGNS =
            "\u20AC\0\u201A\u0192\u201E\u2026\u2020\u2021\u02C6\u2030\u0160\u2039\u0152\0\u017D\0"
                    + "\0\u2018\u2019\u201C\u201D\u2022\u2013\u2014\u02DC\u2122\u0161\u203A\u0153\0\u017E\u0178";

    private Windows1252() {}

    /** Decodes a byte. Returns {@code \0} for undefined bytes and for control codes that do not occur in text. */
    static char decode(byte encoded) {
        int code = encoded & 0xFF;
        if (code >= FIRST && code < FIRST + SIGNS.length()) {
            return SIGNS.charAt(code - FIRST);
        }
        boolean isControl = (code < ' ' && "\t\n\r\f".indexOf(code) < 0) || code == 0x7F;
        return isControl ? '\0' : (char) code;
    }

    /** Encodes a character as a byte from 0 to 255. Returns a negative number if the code page lacks the character. */
    static int encode(char character) {
        int sign = character == '\0' ? -1 : SIGNS.indexOf(character);
        if (sign >= 0) {
            return FIRST + sign;
        }
        boolean isLatin = character < FIRST || (character >= FIRST + SIGNS.length() && character <= 0xFF);
        return isLatin ? character : -1;
    }
}

package org.robonewbie.nao.text;

import java.util.Locale;
import java.util.Optional;

/**
 * A character that is invisible or looks like another one, typically pasted from a web page or a PDF: a no-break space, a
 * zero-width space, a curly quotation mark, a dash in place of a minus, a Cyrillic letter in a Latin word.
 *
 * <p>Source: Unicode Technical Standard 39, "confusables", reduced to the characters that occur in practice.
 *
 * @param number one-based position in the text, in characters
 * @param codePoint the character
 */
public record ConfusableCharacter(int number, int codePoint) {

    private static final String LETTERS = "аеорсухіјѕһԁӏкАВЕЗКМНОРСТХУІЈЅοΑΒΕΖΗΙΚΜΝΟΡΤΥΧ";
    private static final String LATIN = "aeopcyxijshdlkABE3KMHOPCTXYIJSoABEZHIKMNOPTYX";
    private static final int FULL_WIDTH = 0xFF01 - '!';
    private static final int APOSTROPHE = 0x2019;

    /**
     * Finds the first confusable character in a name, an option or a path. Legitimate uses in other languages do not count: the
     * letters of an entirely Cyrillic word, an apostrophe, a dash between words.
     *
     * @param text a line or part of one
     * @return the first confusable character; empty if there is none
     */
    public static Optional<ConfusableCharacter> firstIn(String text) {
        int number = 1;
        int next;
        for (int i = 0; i < text.length(); i = next, number++) {
            int code = text.codePointAt(i);
            next = i + Character.charCount(code);
            if (isConfusable(text, i, next, code)) {
                return Optional.of(new ConfusableCharacter(number, code));
            }
        }
        return Optional.empty();
    }

    /**
     * Returns whether two strings look the same, ignoring case.
     *
     * @param text a string
     * @param other another string
     * @return whether the strings look the same, although their characters may differ
     */
    public static boolean looksLike(String text, String other) {
        return plain(text).equals(plain(other));
    }

    /**
     * Describes the difference between two strings that look the same.
     *
     * @param text the string as written
     * @param meant the intended string
     * @return a clause, such as {@code character 4 is a no-break space (U+00A0): type an ordinary space}
     */
    static String difference(String text, String meant) {
        int number = 1;
        int next;
        for (int i = 0; i < text.length(); i = next, number++) {
            int code = text.codePointAt(i);
            next = i + Character.charCount(code);
            if (meant.indexOf(code) < 0 && code >= 0x80) {
                return new ConfusableCharacter(number, code).toString();
            }
        }
        return "its characters differ: type it again";
    }

    @Override
    public String toString() {
        return "character " + number + " is " + description() + ": " + advice();
    }

    private String description() {
        return name() + " (U+" + String.format(Locale.ROOT, "%04X", codePoint) + ")";
    }

    private String name() {
        return switch (codePoint) {
            case 0xA0, 0x202F -> "a no-break space";
            case 0xAD -> "an invisible soft hyphen";
            case 0xFEFF -> "an invisible byte order mark";
            default -> {
                if (isSpace(codePoint)) {
                    yield "a space of special width";
                }
                if (isInvisible(codePoint)) {
                    yield "an invisible character";
                }
                if (isMark(codePoint)) {
                    yield "a combining accent";
                }
                if (isQuote(codePoint)) {
                    yield "the quotation mark " + text(codePoint);
                }
                if (isDash(codePoint)) {
                    yield "the dash " + text(codePoint);
                }
                yield (codePoint < 0x400
                                ? "the Greek letter "
                                : codePoint < 0x530 ? "the Cyrillic letter " : "the character ")
                        + text(codePoint);
            }
        };
    }

    private String advice() {
        if (isSpace(codePoint)) {
            return "type an ordinary space";
        }
        if (isInvisible(codePoint)) {
            return "delete it";
        }
        if (isMark(codePoint)) {
            return "type the letter with its accent as one character";
        }
        if (isQuote(codePoint)) {
            return "type ' or \", or none";
        }
        if (isDash(codePoint)) {
            return "type -";
        }
        String plain = plain(text(codePoint));
        return plain.equals(text(codePoint)) ? "type another character" : "type " + latin(codePoint);
    }

    private static boolean isConfusable(String text, int from, int to, int code) {
        if (code < 0x80) {
            return false;
        }
        if (isSpace(code) || isInvisible(code) || isFullWidth(code)) {
            return true;
        }
        boolean startsWord = from == 0 || " =,:([{".indexOf(text.charAt(from - 1)) >= 0;
        boolean endsWord = to == text.length() || " =,:)]}".indexOf(text.charAt(to)) >= 0;
        if (isQuote(code)) {
            return code != APOSTROPHE || startsWord || endsWord;
        }
        if (isDash(code)) {
            return startsWord && !endsWord;
        }
        return LETTERS.indexOf(code) >= 0 && isInLatinWord(text, from);
    }

    private static boolean isInLatinWord(String text, int at) {
        int from = at;
        while (from > 0 && Character.isLetter(text.charAt(from - 1))) {
            from--;
        }
        for (int i = from; i < text.length() && Character.isLetter(text.charAt(i)); i++) {
            char letter = text.charAt(i);
            if (letter < 0x80 || (letter >= 0xC0 && letter < 0x250)) {
                return true;
            }
        }
        return false;
    }

    /**
     * Returns the skeleton of a string: each character is replaced with the ASCII character that it looks like, in
     * lower case.
     */
    private static String plain(String text) {
        StringBuilder plain = new StringBuilder();
        text.codePoints().forEach(code -> {
            if (isSpace(code)) {
                plain.append(' ');
            } else if (isQuote(code)) {
                plain.append('\'');
            } else if (isDash(code)) {
                plain.append('-');
            } else if (isMark(code)) {
                plain.append(composed(plain, code));
            } else if (!isInvisible(code)) {
                plain.append(Character.toChars(latin(code).codePointAt(0)));
            }
        });
        return plain.toString().strip().toLowerCase(Locale.ROOT);
    }

    private static String latin(int code) {
        if (isFullWidth(code)) {
            return text(code - FULL_WIDTH);
        }
        int at = LETTERS.indexOf(code);
        return at < 0 ? text(code) : LATIN.substring(at, at + 1);
    }

    /** Removes the last letter and returns it with an accent; returns an empty string if there is no such accented letter. */
    private static String composed(StringBuilder letters, int mark) {
        int last = letters.length() - 1;
        String pairs = switch (mark) {
            case 0x300 -> "aàeèiìoòuùAÀEÈIÌOÒUÙ";
            case 0x301 -> "aáeéiíoóuúyýAÁEÉIÍOÓUÚYÝ";
            case 0x302 -> "aâeêiîoôuûAÂEÊIÎOÔUÛ";
            case 0x303 -> "aãnñoõAÃNÑOÕ";
            case 0x308 -> "aäeëiïoöuüyÿAÄEËIÏOÖUÜ";
            case 0x30A -> "aåAÅ";
            case 0x327 -> "cçCÇ";
            default -> "";
        };
        for (int i = 0; last >= 0 && i < pairs.length(); i += 2) {
            if (pairs.charAt(i) == letters.charAt(last)) {
                letters.setLength(last);
                return pairs.substring(i + 1, i + 2);
            }
        }
        return "";
    }

    private static boolean isSpace(int code) {
        return code == 0xA0 || (code >= 0x2000 && code <= 0x200A) || code == 0x202F || code == 0x205F || code == 0x3000;
    }

    private static boolean isInvisible(int code) {
        return code == 0xAD
                || (code >= 0x200B && code <= 0x200F)
                || (code >= 0x2028 && code <= 0x202E)
                || (code >= 0x2060 && code <= 0x2069)
                || code == 0xFEFF;
    }

    private static boolean isMark(int code) {
        return code >= 0x300 && code < 0x370;
    }

    private static boolean isQuote(int code) {
        return (code >= 0x2018 && code <= 0x201F) || code == 0xAB || code == 0xBB || code == 0xB4 || code == 0x2032;
    }

    private static boolean isDash(int code) {
        return (code >= 0x2010 && code <= 0x2015) || code == 0x2212;
    }

    private static boolean isFullWidth(int code) {
        return code >= 0xFF01 && code <= 0xFF5E;
    }

    /** Converts a code point to a string; TeaVM's library lacks {@code Character.toString(int)}. */
    private static String text(int character) {
        return String.valueOf(Character.toChars(character));
    }
}

package org.robonewbie.nao.text;

import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * Checks whether file names, in any script, are valid on Windows, macOS and Linux. The studio's pages implement the
 * same rules in {@code state/file-name.js}.
 *
 * <pre>{@code
 * FileName.problem("grüßen");   // empty
 * FileName.problem("a/b");      // contains "/"
 * }</pre>
 */
public final class FileName {

    /** Maximum length of a name in UTF-16 characters; its UTF-8 bytes then fit into the 255 that file systems allow. */
    public static final int MAX_CHARACTERS = 80;

    /** Path separators, characters that Windows rejects, and the escape character of URLs. */
    private static final String RESERVED = "/\\:*?\"<>|%";

    /** Spaces that look like an ordinary one. The ideographic space is valid, because Japanese keyboards produce it. */
    private static final String OTHER_SPACES =
            "\u00A0\u1680\u2000\u2001\u2002\u2003\u2004\u2005\u2006\u2007\u2008\u2009\u200A\u202F\u205F";

    private static final String INVISIBLE = "\u00AD\u061C\u180E\u200B\u200E\u200F\uFEFF\uFFF9\uFFFA\uFFFB\uFFFE\uFFFF";

    /** Device names on Windows, with any extension. */
    private static final Pattern DEVICE =
            Pattern.compile("(con|prn|aux|nul|(com|lpt)[0-9\u00b9\u00b2\u00b3]) *(\\..*)?");

    private FileName() {}

    /**
     * Returns whether Windows accepts and preserves a name.
     *
     * @param name a name without folder, with or without extension
     * @return false for the name of a device, and for a trailing space or dot, which Windows drops
     */
    public static boolean isPortable(String name) {
        return !DEVICE.matcher(name.toLowerCase(Locale.ROOT)).matches() && !name.endsWith(".") && !name.endsWith(" ");
    }

    /**
     * Returns whether a name is short and plain.
     *
     * @param name a name without folder or extension
     * @param signs valid characters besides letters and digits
     * @param maxCharacters maximum length
     * @return whether it begins with a letter or digit, contains only letters, digits and the given characters, and is
     *     {@linkplain #isPortable portable}
     */
    public static boolean isPlain(String name, String signs, int maxCharacters) {
        return !name.isEmpty()
                && name.length() <= maxCharacters
                && isLetterOrNumber(name.codePointAt(0))
                && name.codePoints().allMatch(each -> isLetterOrNumber(each) || signs.indexOf(each) >= 0)
                && isPortable(name);
    }

    private static boolean isLetterOrNumber(int character) {
        int type = Character.getType(character);
        return Character.isLetter(character)
                || (type >= Character.DECIMAL_DIGIT_NUMBER && type <= Character.OTHER_NUMBER);
    }

    /**
     * Checks a name that a user chose.
     *
     * @param name a name without folder or extension
     * @return the problem, phrased to follow the name in a sentence, such as {@code contains "/"}; empty if the name is
     *     valid
     */
    public static Optional<String> problem(String name) {
        if (name.isEmpty()) {
            return Optional.of("is empty");
        }
        if (name.length() > MAX_CHARACTERS) {
            return Optional.of("has " + name.length() + " characters, more than the " + MAX_CHARACTERS + " allowed");
        }
        for (int i = 0; i < name.length(); i++) {
            String wrong = problem(name, i);
            if (!wrong.isEmpty()) {
                return Optional.of("contains " + wrong);
            }
        }
        if (name.startsWith(".") || name.startsWith(" ")) {
            return Optional.of("begins with a " + signName(name.charAt(0)));
        }
        if (name.endsWith(".") || name.endsWith(" ")) {
            return Optional.of("ends with a " + signName(name.charAt(name.length() - 1)));
        }
        return isPortable(name) ? Optional.empty() : Optional.of("is the name of a device on Windows");
    }

    private static String signName(char sign) {
        return sign == '.' ? "dot" : "space";
    }

    /** Returns the problem with a character of a name; empty if it is valid. */
    private static String problem(String name, int at) {
        char character = name.charAt(at);
        if (RESERVED.indexOf(character) >= 0) {
            return "\"" + character + "\"";
        }
        if (character < ' ' || (character >= 0x7F && character <= 0x9F)) {
            return "the control character " + code(character);
        }
        if (OTHER_SPACES.indexOf(character) >= 0) {
            return "the space character " + code(character) + " instead of an ordinary space";
        }
        boolean isDirection = character >= 0x2028 && character <= 0x202E;
        boolean isFormat = character >= 0x2060 && character <= 0x206F;
        if (isDirection || isFormat || INVISIBLE.indexOf(character) >= 0) {
            return "the invisible character " + code(character);
        }
        return isUnpairedSurrogate(name, at) ? "the unpaired surrogate " + code(character) : "";
    }

    private static boolean isUnpairedSurrogate(String name, int at) {
        char character = name.charAt(at);
        boolean hasLow = at + 1 < name.length() && Character.isLowSurrogate(name.charAt(at + 1));
        boolean hasHigh = at > 0 && Character.isHighSurrogate(name.charAt(at - 1));
        return (Character.isHighSurrogate(character) && !hasLow) || (Character.isLowSurrogate(character) && !hasHigh);
    }

    private static String code(char character) {
        String digits = "000" + Integer.toHexString(character).toUpperCase(Locale.ROOT);
        return "U+" + digits.substring(digits.length() - 4);
    }
}

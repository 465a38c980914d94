package org.robonewbie.nao.text;

import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * Names that a file can have on Windows, macOS and Linux alike, in the letters of any language. The pages of the studio have the
 * same rule in {@code state/file-name.js}.
 *
 * <pre>{@code
 * FileName.problem("grüßen");   // empty
 * FileName.problem("a/b");      // contains "/"
 * }</pre>
 */
public final class FileName {

    /** How long a name may be, so that its bytes fit into the 255 that file systems allow; in UTF-16 characters. */
    public static final int MAX_CHARACTERS = 80;

    /** What separates folders, what Windows refuses, and the sign that addresses of pages give another meaning. */
    private static final String RESERVED = "/\\:*?\"<>|%";

    /** Blanks that look like that of the space bar; the ideographic one is what Japanese keyboards write. */
    private static final String OTHER_BLANKS =
            "\u00A0\u1680\u2000\u2001\u2002\u2003\u2004\u2005\u2006\u2007\u2008\u2009\u200A\u202F\u205F";

    private static final String INVISIBLE = "\u00AD\u061C\u180E\u200B\u200E\u200F\uFEFF\uFFF9\uFFFA\uFFFB\uFFFE\uFFFF";

    /** What Windows takes for a device, whatever ending it has. */
    private static final Pattern DEVICE =
            Pattern.compile("(con|prn|aux|nul|(com|lpt)[0-9\u00b9\u00b2\u00b3]) *(\\..*)?");

    private FileName() {}

    /**
     * Whether every system can have a file of this name beside others.
     *
     * @param name a name without folder, with or without ending
     * @return false for what Windows takes for a device, and for a blank or dot at the end, which it drops
     */
    public static boolean isPortable(String name) {
        return !DEVICE.matcher(name.toLowerCase(Locale.ROOT)).matches() && !name.endsWith(".") && !name.endsWith(" ");
    }

    /**
     * Checks a name that a person has chosen.
     *
     * @param name a name without folder and ending
     * @return what is wrong with it, such as {@code contains "/"}, to be put behind the name; empty if nothing is
     */
    public static Optional<String> problem(String name) {
        if (name.isEmpty()) {
            return Optional.of("is empty");
        }
        if (name.length() > MAX_CHARACTERS) {
            return Optional.of("has " + name.length() + " characters, and " + MAX_CHARACTERS + " are the most");
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
        return sign == '.' ? "dot" : "blank";
    }

    /** What is wrong with the character there; empty if nothing is. */
    private static String problem(String name, int at) {
        char character = name.charAt(at);
        if (RESERVED.indexOf(character) >= 0) {
            return "\"" + character + "\"";
        }
        if (character < ' ' || (character >= 0x7F && character <= 0x9F)) {
            return "the control character " + code(character);
        }
        if (OTHER_BLANKS.indexOf(character) >= 0) {
            return "the blank " + code(character) + ", which is not that of the space bar";
        }
        boolean isDirection = character >= 0x2028 && character <= 0x202E;
        boolean isFormat = character >= 0x2060 && character <= 0x206F;
        if (isDirection || isFormat || INVISIBLE.indexOf(character) >= 0) {
            return "the invisible character " + code(character);
        }
        return isHalf(name, at) ? "half a character (" + code(character) + ")" : "";
    }

    private static boolean isHalf(String name, int at) {
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

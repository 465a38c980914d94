package org.robonewbie.nao.text;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Checks whether file names, in any script, are valid on Windows, macOS and Linux.
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
    private static final String RESERVED = "[/\\\\:*?\"<>|%]";

    private static final String CONTROL = "\\p{Cc}";

    /** Spaces that look like an ordinary one. The ideographic space is valid, because Japanese keyboards produce it. */
    private static final String OTHER_SPACES = "[\\u00A0\\u1680\\u2000-\\u200A\\u202F\\u205F]";

    private static final String INVISIBLE =
            "[\\u00AD\\u061C\\u180E\\u200B\\u200E\\u200F\\u2028-\\u202E\\u2060-\\u206F\\uFEFF\\uFFF9-\\uFFFB\\uFFFE\\uFFFF]";

    private static final String UNPAIRED = "\\p{Cs}";

    /** Device names on Windows, with any extension. */
    private static final String DEVICE = "^(?:con|prn|aux|nul|(?:com|lpt)[0-9\\u00B9\\u00B2\\u00B3]) *(?:\\..*)?$";

    /** Matches an invalid character. */
    public static final Pattern INVALID =
            Pattern.compile(String.join("|", RESERVED, CONTROL, OTHER_SPACES, INVISIBLE, UNPAIRED));

    /** Problems of the first invalid character of a name, or of a name without one; the first that fits is meant. */
    public static final List<Problem> PROBLEMS = List.of(
            Problem.of(RESERVED, "contains \"SIGN\""),
            Problem.of(CONTROL, "contains the control character CODE"),
            Problem.of(OTHER_SPACES, "contains the space character CODE instead of an ordinary space"),
            Problem.of(INVISIBLE, "contains the invisible character CODE"),
            Problem.of(UNPAIRED, "contains the unpaired surrogate CODE"),
            Problem.of("^$", "is empty"),
            Problem.of("^\\.", "begins with a dot"),
            Problem.of("^ ", "begins with a space"),
            Problem.of("\\.$", "ends with a dot"),
            Problem.of(" $", "ends with a space"),
            Problem.of(DEVICE, "is the name of a device on Windows"));

    /**
     * A problem of names. The pages of the studio use the same pattern in JavaScript.
     *
     * @param pattern matches what has the problem
     * @param words the problem, phrased to follow the name; SIGN stands for the invalid character, and CODE for its code
     */
    public record Problem(Pattern pattern, String words) {

        private static Problem of(String pattern, String words) {
            return new Problem(Pattern.compile(pattern, Pattern.CASE_INSENSITIVE), words);
        }
    }

    private FileName() {}

    /**
     * Returns whether a name is short and plain.
     *
     * @param name a name without folder or extension
     * @param signs valid characters besides letters and digits
     * @param maxCharacters maximum length
     * @return whether it begins with a letter or digit, contains only letters, digits and the given characters, and has
     *     no {@linkplain #problem problem}
     */
    public static boolean isPlain(String name, String signs, int maxCharacters) {
        return problem(name).isEmpty()
                && name.length() <= maxCharacters
                && isLetterOrNumber(name.codePointAt(0))
                && name.codePoints().allMatch(each -> isLetterOrNumber(each) || signs.indexOf(each) >= 0);
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
        if (name.length() > MAX_CHARACTERS) {
            return Optional.of("has " + name.length() + " characters, more than the " + MAX_CHARACTERS + " allowed");
        }
        Matcher invalid = INVALID.matcher(name);
        String wrong = invalid.find() ? invalid.group() : name;
        String code = String.format(
                Locale.ROOT, "U+%04X", wrong.codePoints().findFirst().orElse(0));
        return PROBLEMS.stream()
                .filter(each -> each.pattern.matcher(wrong).find())
                .map(each -> each.words.replace("SIGN", wrong).replace("CODE", code))
                .findFirst();
    }
}

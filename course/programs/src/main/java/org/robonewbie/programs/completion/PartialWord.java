package org.robonewbie.programs.completion;

/**
 * The partly typed identifier at the cursor.
 *
 * @param text the program with {@link #STAND_IN} in place of the identifier
 * @param begun the part before the cursor
 */
public record PartialWord(String text, String begun) {

    /** Placeholder that marks the cursor in the syntax tree. */
    static final String STAND_IN = "__here__";

    /**
     * Finds the identifier at a position.
     *
     * @param text a program
     * @param at index of the cursor
     * @return the identifier, which may be empty
     */
    public static PartialWord at(String text, int at) {
        int start = at;
        while (start > 0 && Character.isJavaIdentifierPart(text.charAt(start - 1))) {
            start--;
        }
        int end = at;
        while (end < text.length() && Character.isJavaIdentifierPart(text.charAt(end))) {
            end++;
        }
        return new PartialWord(text.substring(0, start) + STAND_IN + text.substring(end), text.substring(start, at));
    }
}

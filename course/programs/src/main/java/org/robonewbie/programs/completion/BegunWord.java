package org.robonewbie.programs.completion;

/**
 * The word that somebody is writing.
 *
 * @param text the program with {@link #STAND_IN} in the place of the word
 * @param begun what of the word is there
 */
public record BegunWord(String text, String begun) {

    /** A word that nobody writes, by which the compiler finds the place. */
    static final String STAND_IN = "__here__";

    /**
     * Finds the word at a place.
     *
     * @param text a program
     * @param at index of the place
     * @return the word, which may be empty
     */
    public static BegunWord at(String text, int at) {
        int start = at;
        while (start > 0 && Character.isJavaIdentifierPart(text.charAt(start - 1))) {
            start--;
        }
        int end = at;
        while (end < text.length() && Character.isJavaIdentifierPart(text.charAt(end))) {
            end++;
        }
        return new BegunWord(text.substring(0, start) + STAND_IN + text.substring(end), text.substring(start, at));
    }
}

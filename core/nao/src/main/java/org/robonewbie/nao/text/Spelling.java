package org.robonewbie.nao.text;

import java.util.Arrays;
import java.util.Collection;
import java.util.Comparator;
import java.util.Locale;
import java.util.Optional;
import java.util.function.UnaryOperator;

/**
 * Finds what was probably meant by a misspelt word: one that looks the same, one that contains what was written, else the one
 * with the smallest edit distance (Levenshtein, 1965). A word is never proposed for itself.
 */
public final class Spelling {

    private static final int SHORTEST_PART = 3;
    private static final int MAX_WRONG_LETTERS = 2;

    private Spelling() {}

    /**
     * Looks for the word that is most like a misspelt one; capitals do not matter.
     *
     * @param misspelt what was written
     * @param words what could have been meant
     * @return the most similar word; empty if none is near, or if what was written is one of them
     */
    public static Optional<String> nearest(String misspelt, Collection<String> words) {
        return words.contains(misspelt)
                ? Optional.empty()
                : lookingAlike(misspelt, words)
                        .or(() -> containing(misspelt.toLowerCase(Locale.ROOT), words))
                        .or(() -> similar(misspelt, words));
    }

    /**
     * Asks whether another word was meant.
     *
     * @param misspelt what was written
     * @param words what could have been meant
     * @return a blank and {@code Did you mean walk?}; or the character that makes the difference, if both look the same; empty
     *     if no word is near
     */
    public static String question(String misspelt, Collection<String> words) {
        return question(misspelt, words, UnaryOperator.identity());
    }

    /**
     * Asks whether another word was meant.
     *
     * @param misspelt what was written
     * @param words what could have been meant
     * @param form how the found word is shown, such as in quotation marks
     * @return a blank and {@code Did you mean "walk"?}; or the character that makes the difference, if both look the same;
     *     empty if no word is near
     */
    public static String question(String misspelt, Collection<String> words, UnaryOperator<String> form) {
        return nearest(misspelt, words)
                .map(word -> isSeenToDiffer(misspelt, word)
                        ? " Did you mean " + form.apply(word) + "?"
                        : " It looks like " + form.apply(word) + ", but "
                                + ConfusableCharacter.difference(misspelt, word) + ".")
                .orElse("");
    }

    /** Whether a reader can see the difference, be it one of capitals only. */
    private static boolean isSeenToDiffer(String misspelt, String word) {
        return !ConfusableCharacter.looksLike(misspelt, word)
                || misspelt.chars().allMatch(letter -> letter < 0x80)
                || misspelt.equalsIgnoreCase(word);
    }

    private static Optional<String> lookingAlike(String misspelt, Collection<String> words) {
        return words.stream()
                .filter(word -> ConfusableCharacter.looksLike(misspelt, word))
                .findFirst();
    }

    private static Optional<String> containing(String part, Collection<String> words) {
        return words.stream()
                .filter(word -> part.length() >= SHORTEST_PART
                        && word.toLowerCase(Locale.ROOT).contains(part))
                .min(Comparator.comparingInt(String::length));
    }

    private static Optional<String> similar(String misspelt, Collection<String> words) {
        return words.stream()
                .min(Comparator.comparingInt(word -> distance(word, misspelt)))
                .filter(word -> distance(word, misspelt) <= Math.max(MAX_WRONG_LETTERS, word.length() / 2));
    }

    /** Levenshtein's distance: how many letters must be changed, added or taken away. */
    private static int distance(String from, String to) {
        int[] row = new int[to.length() + 1];
        Arrays.setAll(row, i -> i);
        for (int i = 1; i <= from.length(); i++) {
            int diagonal = row[0];
            row[0] = i;
            for (int j = 1; j <= to.length(); j++) {
                boolean same = Character.toLowerCase(from.charAt(i - 1)) == Character.toLowerCase(to.charAt(j - 1));
                int replaced = diagonal + (same ? 0 : 1);
                diagonal = row[j];
                row[j] = Math.min(replaced, 1 + Math.min(row[j], row[j - 1]));
            }
        }
        return row[to.length()];
    }
}

package org.robonewbie.nao.text;

import java.util.Arrays;
import java.util.Collection;
import java.util.Comparator;
import java.util.Locale;
import java.util.Optional;
import java.util.function.UnaryOperator;

/**
 * Suggests corrections for misspelt words: a word that looks the same; failing that, one that contains the misspelt
 * word; failing that, the one with the smallest edit distance (Levenshtein, 1965).
 */
public final class Spelling {

    private static final int MIN_PART = 3;
    private static final int MAX_WRONG_LETTERS = 2;

    private Spelling() {}

    /**
     * Finds the word that is most similar to a misspelt one, ignoring case.
     *
     * @param misspelt the word as written
     * @param words the valid words
     * @return the most similar word; empty if no word is similar, or if the word is valid
     */
    public static Optional<String> nearest(String misspelt, Collection<String> words) {
        return words.contains(misspelt)
                ? Optional.empty()
                : lookingAlike(misspelt, words)
                        .or(() -> containing(misspelt.toLowerCase(Locale.ROOT), words))
                        .or(() -> similar(misspelt, words));
    }

    /**
     * Returns a suggestion to append to an error message.
     *
     * @param misspelt the word as written
     * @param words the valid words
     * @return a space and {@code Did you mean walk?}; if both words look the same, a space and a description of the character that
     *     differs; empty if no word is similar
     */
    public static String question(String misspelt, Collection<String> words) {
        return question(misspelt, words, UnaryOperator.identity());
    }

    /**
     * Returns a suggestion to append to an error message.
     *
     * @param misspelt the word as written
     * @param words the valid words
     * @param form formats the suggested word, for example in quotation marks
     * @return a space and {@code Did you mean "walk"?}; if both words look the same, a space and a description of the character
     *     that differs; empty if no word is similar
     */
    public static String question(String misspelt, Collection<String> words, UnaryOperator<String> form) {
        return nearest(misspelt, words)
                .map(word -> differsVisibly(misspelt, word)
                        ? " Did you mean " + form.apply(word) + "?"
                        : " It looks like " + form.apply(word) + ", but "
                                + ConfusableCharacter.difference(misspelt, word) + ".")
                .orElse("");
    }

    private static boolean differsVisibly(String misspelt, String word) {
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
                .filter(word -> part.length() >= MIN_PART
                        && word.toLowerCase(Locale.ROOT).contains(part))
                .min(Comparator.comparingInt(String::length));
    }

    private static Optional<String> similar(String misspelt, Collection<String> words) {
        return words.stream()
                .min(Comparator.comparingInt(word -> distance(word, misspelt)))
                .filter(word -> distance(word, misspelt) <= Math.max(MAX_WRONG_LETTERS, word.length() / 2));
    }

    /** Returns the Levenshtein distance, ignoring case. */
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

package org.robonewbie.protocol.perceptor;

import org.robonewbie.protocol.sexp.SexpReader;

/** Cache of strings that recur in each message, such as team names, to avoid allocating them again. */
final class KnownWords {

    private final String[] words = {"", "", "", "", "", "", "", ""};
    private int oldest;

    /** Returns the current atom as a string, from the cache if possible. */
    String of(SexpReader reader) {
        for (String word : words) {
            if (reader.atomIs(word)) {
                return word;
            }
        }
        String word = reader.text();
        words[oldest] = word;
        oldest = (oldest + 1) % words.length;
        return word;
    }
}

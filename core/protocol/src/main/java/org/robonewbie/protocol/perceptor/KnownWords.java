package org.robonewbie.protocol.perceptor;

import org.robonewbie.protocol.sexp.SexpReader;

/** The few names that recur in each message, such as teams, cached so that each is created only once. */
final class KnownWords {

    private final String[] words = {"", "", "", "", "", "", "", ""};
    private int oldest;

    /** Returns the current atom as text. */
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

package org.robonewbie.protocol.perceptor;

import org.robonewbie.protocol.sexp.SexpReader;

/** The few names that come again in each message, such as teams: kept so that each is made only once. */
final class KnownWords {

    private final String[] words = {"", "", "", "", "", "", "", ""};
    private int oldest;

    /** Gives the current atom as text. */
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

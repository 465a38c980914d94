package org.robonewbie.protocol.perceptor;

import org.robonewbie.protocol.sexp.SexpReader;

/** Cache of names that recur in each message, such as teams, which avoids repeated allocations. */
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

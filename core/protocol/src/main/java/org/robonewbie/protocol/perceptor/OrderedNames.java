package org.robonewbie.protocol.perceptor;

import java.util.List;
import org.robonewbie.protocol.sexp.SexpReader;

/** Names that messages list in a fixed order, such as those of joints: the search starts after the last name that was found. */
final class OrderedNames {

    private final String[] names;
    private int expected;

    OrderedNames(List<String> names) {
        this.names = names.toArray(String[]::new);
    }

    /** Returns the index of the current atom, or -1 if it is none of the names. */
    int indexOf(SexpReader reader) {
        for (int i = 0; i < names.length; i++) {
            int candidate = (expected + i) % names.length;
            if (reader.atomIs(names[candidate])) {
                expected = candidate + 1;
                return candidate;
            }
        }
        return -1;
    }
}

package org.robonewbie.simulator.physics.sparse;

import java.util.Arrays;

/** Growable list of primitive integers whose array is reused after {@link #clear}. */
final class IntegerList {

    /** Backing array; only the first {@link #size} elements are valid. */
    int[] elements = {};

    private int size;

    int size() {
        return size;
    }

    void add(int element) {
        if (size == elements.length) {
            elements = Arrays.copyOf(elements, 16 + 2 * size);
        }
        elements[size++] = element;
    }

    void clear() {
        size = 0;
    }
}

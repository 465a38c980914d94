package org.robonewbie.simulator.physics.sparse;

import java.util.Arrays;

/** Integers in a row, for building factorizations; its array is used again. */
final class IntegerList {

    /** The integers, and room for more. */
    int[] numbers = {};

    private int size;

    int size() {
        return size;
    }

    void add(int number) {
        if (size == numbers.length) {
            numbers = Arrays.copyOf(numbers, 16 + 2 * size);
        }
        numbers[size++] = number;
    }

    void clear() {
        size = 0;
    }
}

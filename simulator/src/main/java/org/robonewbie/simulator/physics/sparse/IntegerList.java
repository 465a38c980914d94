package org.robonewbie.simulator.physics.sparse;

import java.util.Arrays;

/** Integers in a row, for building plans. */
final class IntegerList {

    private int[] numbers = new int[16];
    private int size;

    void add(int number) {
        if (size == numbers.length) {
            numbers = Arrays.copyOf(numbers, 2 * size);
        }
        numbers[size++] = number;
    }

    int[] toArray() {
        return Arrays.copyOf(numbers, size);
    }
}

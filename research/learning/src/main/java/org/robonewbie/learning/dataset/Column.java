package org.robonewbie.learning.dataset;

/**
 * One column of a table. The JSON in {@code dataset.json} uses the names of these record components.
 *
 * @param name a name such as {@code true_left_knee_pitch}
 * @param kind the type of the cells: {@code decimal} for {@link Double} (NaN if missing), {@code whole} for {@link
 *     Long}, {@code text} for {@link String}
 * @param unit a unit such as {@code degrees}; empty if there is none
 * @param meaning a short description
 */
public record Column(String name, String kind, String unit, String meaning) {

    static Column decimal(String name, String unit, String meaning) {
        return new Column(name, "decimal", unit, meaning);
    }

    static Column whole(String name, String unit, String meaning) {
        return new Column(name, "whole", unit, meaning);
    }

    static Column text(String name, String meaning) {
        return new Column(name, "text", "", meaning);
    }
}

package org.robonewbie.nao.motion;

/**
 * An error or a warning about a motion file.
 *
 * @param line one-based line number
 * @param column one-based column number
 * @param text description, with what was found and what was expected
 */
public record MotionProblem(int line, int column, String text) {

    /** {@return position and text, such as {@code line 7, column 31: 21 angles, expected 22}} */
    @Override
    public String toString() {
        return "line " + line + ", column " + column + ": " + text;
    }
}

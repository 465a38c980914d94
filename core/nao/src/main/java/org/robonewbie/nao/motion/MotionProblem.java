package org.robonewbie.nao.motion;

/**
 * Something in a motion file that is wrong or doubtful.
 *
 * @param line number of the line, from 1
 * @param column number of the character within the line, from 1
 * @param text what was found and what was expected
 */
public record MotionProblem(int line, int column, String text) {

    /** {@return place and text: {@code line 7, column 31: 21 angles, expected 22}} */
    @Override
    public String toString() {
        return "line " + line + ", column " + column + ": " + text;
    }
}

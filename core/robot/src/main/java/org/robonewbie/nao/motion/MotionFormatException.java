package org.robonewbie.nao.motion;

/**
 * Thrown when a motion file cannot be parsed. The message gives the file, line and column, what was found and what was
 * expected.
 */
public final class MotionFormatException extends RuntimeException {

    private static final long serialVersionUID = 1L;

    MotionFormatException(String fileName, MotionProblem problem) {
        super(fileName + " " + problem);
    }
}

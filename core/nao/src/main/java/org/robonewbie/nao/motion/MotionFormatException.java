package org.robonewbie.nao.motion;

/** A motion file cannot be understood; the message names file, line and column, what was found and what was expected. */
public final class MotionFormatException extends RuntimeException {

    private static final long serialVersionUID = 1L;

    private final String fileName;
    private final int line;
    private final int column;

    MotionFormatException(String fileName, MotionProblem finding) {
        super(fileName + " " + finding);
        this.fileName = fileName;
        this.line = finding.line();
        this.column = finding.column();
    }

    /** {@return the file's name} */
    public String fileName() {
        return fileName;
    }

    /** {@return the number of the line, from 1} */
    public int line() {
        return line;
    }

    /** {@return the number of the character within the line, from 1} */
    public int column() {
        return column;
    }
}

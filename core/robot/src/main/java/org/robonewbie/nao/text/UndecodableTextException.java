package org.robonewbie.nao.text;

import java.io.IOException;

/** Thrown when bytes are not valid text in any supported encoding. The message contains the line number. */
public final class UndecodableTextException extends IOException {

    private static final long serialVersionUID = 1L;

    private final int line;
    private final String problem;

    UndecodableTextException(int line, String problem) {
        super("line " + line + " " + problem + ". " + DecodedText.SAVE_AS_UTF_8);
        this.line = line;
        this.problem = problem + ". " + DecodedText.SAVE_AS_UTF_8;
    }

    /** {@return the problem and advice, phrased to follow the line number in a sentence} */
    public String problem() {
        return problem;
    }

    /** {@return the one-based number of the first line that could not be decoded} */
    public int line() {
        return line;
    }
}

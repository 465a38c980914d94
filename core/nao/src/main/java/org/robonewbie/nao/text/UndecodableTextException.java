package org.robonewbie.nao.text;

import java.io.IOException;

/** Says that bytes are no text in an encoding that is understood, and in which line. */
public final class UndecodableTextException extends IOException {

    private static final long serialVersionUID = 1L;

    private final int line;
    private final String problem;

    UndecodableTextException(int line, String problem) {
        super("line " + line + " " + problem + ". " + DecodedText.SAVE_AS_UTF_8);
        this.line = line;
        this.problem = problem + ". " + DecodedText.SAVE_AS_UTF_8;
    }

    /** {@return what is wrong with the line and what to do, to be put behind its number} */
    public String problem() {
        return problem;
    }

    /** {@return the first line that could not be decoded, from 1} */
    public int line() {
        return line;
    }
}

package org.robonewbie.nao.text;

import java.io.IOException;

/** Says that bytes are no text in an encoding that is understood, and in which line. */
public final class UndecodableTextException extends IOException {

    private static final long serialVersionUID = 1L;

    private final int line;

    UndecodableTextException(int line, String problem) {
        super("line " + line + " " + problem + ". " + DecodedText.SAVE_AS_UTF_8);
        this.line = line;
    }

    /** {@return the first line that could not be decoded, from 1} */
    public int line() {
        return line;
    }
}

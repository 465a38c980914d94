package org.robonewbie.protocol.sexp;

/** The kinds of tokens of a {@link SexpReader}. */
public enum Token {
    /** An opening parenthesis, which starts a list. */
    OPEN,
    /** A closing parenthesis, which ends the innermost list. */
    CLOSE,
    /** A word or number. */
    ATOM,
    /** The end of the message. */
    END
}

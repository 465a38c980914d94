package org.robonewbie.protocol.sexp;

/** The kinds of tokens that a {@link SexpReader} returns. */
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

package org.robonewbie.protocol.sexp;

/** The kinds of token that a {@link SexpReader} finds in a message. */
public enum Token {
    /** An opening parenthesis: a list begins. */
    OPEN,
    /** A closing parenthesis: the innermost list ends. */
    CLOSE,
    /** A word or number. */
    ATOM,
    /** The end of the message. */
    END
}

package org.robonewbie.protocol.sexp;

/** What a {@link SexpReader} finds next in a message. */
public enum Token {
    /** An opening parenthesis: a list begins. */
    OPEN,
    /** A closing parenthesis: the innermost list ends. */
    CLOSE,
    /** A word or number. */
    ATOM,
    /** Nothing more can be read from this message. */
    END
}

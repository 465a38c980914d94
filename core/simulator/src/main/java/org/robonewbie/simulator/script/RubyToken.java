package org.robonewbie.simulator.script;

/**
 * A token of a Ruby script.
 *
 * @param kind its kind
 * @param text the word or operator; the value of a string or symbol
 * @param line one-based line number
 * @param from index of its first character in the script
 * @param to index just after its last character
 */
record RubyToken(Kind kind, String text, int line, int from, int to) {

    enum Kind {
        /** A name, a constant or a keyword. */
        WORD,
        /** A global variable with its {@code $}. */
        GLOBAL,
        NUMBER,
        /** A string or symbol with a known value. */
        STRING,
        /** A string whose value only Ruby can compute, such as one with interpolation. */
        OTHER_STRING,
        SIGN,
        /** The end of a line or a semicolon. */
        SEPARATOR
    }

    boolean is(Kind wanted, String word) {
        return kind == wanted && text.equals(word);
    }

    boolean isSign(String sign) {
        return is(Kind.SIGN, sign);
    }

    boolean isWord(String word) {
        return is(Kind.WORD, word);
    }
}

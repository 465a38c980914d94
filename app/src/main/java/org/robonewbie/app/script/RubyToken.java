package org.robonewbie.app.script;

/**
 * A word, number, text or sign of a Ruby script.
 *
 * @param kind what it is
 * @param text the word or sign; of a string or symbol what it stands for
 * @param line its line, 1 for the first
 * @param from index of its first character in the script
 * @param to index behind its last one
 */
record RubyToken(Kind kind, String text, int line, int from, int to) {

    /** What a token is. */
    enum Kind {
        /** A name, a constant or a keyword. */
        WORD,
        /** A global variable with its {@code $}. */
        GLOBAL,
        NUMBER,
        /** A string or symbol whose characters are known. */
        STRING,
        /** A string that only Ruby can put together, such as one with an expression in it. */
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

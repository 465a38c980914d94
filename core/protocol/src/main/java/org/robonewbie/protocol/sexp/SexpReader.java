package org.robonewbie.protocol.sexp;

import java.nio.charset.StandardCharsets;
import org.robonewbie.protocol.frame.MessageBuffer;

/**
 * Pull parser for the S-expressions of a message. It reads the bytes of the message without allocating memory.
 *
 * <p>The rules are those of SimSpark's parser (sfsexp): spaces, tabs and line breaks separate words, {@code ;} between
 * words starts a comment that extends to the end of the line, and an unmatched closing parenthesis ends the message.
 * Nested lists need no stack, so deeply nested input is harmless. Quotation marks are ordinary characters, as in
 * SimSpark's clients; a reader created by {@link #withQuotes} parses quoted strings, as SimSpark's server does.
 *
 * <pre>{@code
 * reader.start(message);
 * while (reader.next() != Token.END) {
 *     if (reader.token() == Token.ATOM && reader.atomIs("now")) { ... }
 * }
 * }</pre>
 */
public final class SexpReader {

    private final DecimalParser decimals = new DecimalParser();
    private byte[] bytes = new byte[0];
    private int end;
    private int position;
    private int depth;
    private Token token = Token.END;
    private int atomStart;
    private int atomEnd;
    private final boolean quoting;

    /** Creates a reader without a message. */
    public SexpReader() {
        this(false);
    }

    private SexpReader(boolean quoting) {
        this.quoting = quoting;
    }

    /**
     * Creates a reader for messages to a server: {@code "two words"} is one atom without its quotation marks, in which a backslash
     * escapes the next character, and {@code '(a b)} is also one atom.
     *
     * @return a reader without a message
     */
    public static SexpReader withQuotes() {
        return new SexpReader(true);
    }

    /**
     * Starts parsing a message, which must not change during parsing.
     *
     * @param message the message
     */
    public void start(MessageBuffer message) {
        start(message.bytes(), 0, message.length());
    }

    /**
     * Starts parsing a range of an array, which must not change during parsing.
     *
     * @param array array that contains the message
     * @param from index of the first byte
     * @param to index after the last byte
     */
    public void start(byte[] array, int from, int to) {
        bytes = array;
        position = from;
        end = to;
        depth = 0;
        token = Token.END;
        atomStart = from;
        atomEnd = from;
    }

    /**
     * Advances to the next token.
     *
     * @return the token; always {@link Token#END} once the end of the message has been reached
     */
    public Token next() {
        token = advance();
        return token;
    }

    /** {@return the current token, as last returned by {@link #next()}} */
    public Token token() {
        return token;
    }

    /** {@return the number of lists that are open after the current token; 0 outside all lists} */
    public int depth() {
        return depth;
    }

    /**
     * Skips tokens until no more than the given number of lists are open, or until {@link Token#END}.
     *
     * @param outerDepth maximum number of open lists
     */
    public void skipTo(int outerDepth) {
        while (depth > outerDepth && next() != Token.END) {
            // each token advances the reader
        }
    }

    /**
     * Advances to the next list {@code (name …)} at the given depth. Skips the rest of the previous list, words between the
     * lists, and lists without a name. Afterwards the name is the current atom.
     *
     * <p>If there is no such list, the current token is {@link Token#CLOSE} if the enclosing list is complete,
     * otherwise {@link Token#END}.
     *
     * @param outerDepth number of enclosing lists; 0 for the top-level lists of the message
     * @return whether there is another list
     */
    public boolean nextList(int outerDepth) {
        skipTo(outerDepth);
        while (depth == outerDepth) {
            Token found = next();
            if (found == Token.END || found == Token.CLOSE) {
                return false;
            }
            if (found == Token.OPEN) {
                if (next() == Token.ATOM) {
                    return true;
                }
                skipTo(outerDepth);
            }
        }
        return false;
    }

    /**
     * Advances to the next token and returns whether it is a number.
     *
     * @return whether {@link #number()} can be called
     */
    public boolean nextNumber() {
        return next() == Token.ATOM && isNumber();
    }

    /**
     * Compares the current atom with a word.
     *
     * @param word the word in ASCII
     * @return whether the atom is exactly this word
     */
    public boolean atomIs(String word) {
        int length = word.length();
        if (atomEnd - atomStart != length) {
            return false;
        }
        for (int i = 0; i < length; i++) {
            if (bytes[atomStart + i] != word.charAt(i)) {
                return false;
            }
        }
        return true;
    }

    /**
     * Parses the current atom as a number following the rules of C's {@code atof}: characters after a number are
     * ignored, text that is not a number counts as 0, and {@code nan} and {@code inf} are supported.
     *
     * @return the number, correctly rounded
     */
    public double number() {
        return decimals.parse(bytes, atomStart, atomEnd);
    }

    /**
     * Parses the current atom as an integer, truncating the fractional part as SimSpark does.
     *
     * @return the number, 0 if the atom is not a number
     */
    public int integer() {
        return (int) number();
    }

    /** {@return whether the current atom starts with a number; if not, {@link #number()} returns 0} */
    public boolean isNumber() {
        return decimals.isNumber(bytes, atomStart, atomEnd);
    }

    /** {@return whether the whole current atom is a decimal number, with nothing after it; {@code nan} and {@code inf} are not} */
    public boolean isDecimal() {
        return decimals.isDecimal(bytes, atomStart, atomEnd);
    }

    /** {@return the length of the current atom in bytes} */
    public int atomLength() {
        return atomEnd - atomStart;
    }

    /** {@return a copy of the current atom as text} */
    public String text() {
        return new String(bytes, atomStart, atomEnd - atomStart, StandardCharsets.UTF_8);
    }

    private Token advance() {
        skipSpaceAndComments();
        while (isApostropheBeforeWord()) {
            position++;
            skipSpaceAndComments();
        }
        if (position >= end) {
            return Token.END;
        }
        byte next = bytes[position];
        if (next == '(') {
            position++;
            depth++;
            return Token.OPEN;
        }
        if (next == ')') {
            return close();
        }
        if (quoting && next == '"') {
            return quotedText();
        }
        if (quoting && next == '\'') {
            return quotedList();
        }
        return word();
    }

    private Token word() {
        atomStart = position;
        position++;
        while (position < end && !endsAtom(bytes[position])) {
            position++;
        }
        atomEnd = position;
        return Token.ATOM;
    }

    /** Parses a quoted string. An unterminated string ends the message. */
    private Token quotedText() {
        position++;
        atomStart = position;
        while (position < end && bytes[position] != '"') {
            position += bytes[position] == '\\' ? 2 : 1;
        }
        if (position >= end) {
            position = end;
            return Token.END;
        }
        atomEnd = position;
        position++;
        return Token.ATOM;
    }

    /** Parses a list preceded by an apostrophe as a single atom. */
    private Token quotedList() {
        position++;
        atomStart = position;
        int open = 0;
        while (position < end) {
            byte next = bytes[position];
            open += next == '(' ? 1 : next == ')' ? -1 : 0;
            position++;
            if (open == 0) {
                atomEnd = position;
                return Token.ATOM;
            }
        }
        return Token.END;
    }

    private Token close() {
        if (depth == 0) {
            position = end;
            return Token.END;
        }
        position++;
        depth--;
        return Token.CLOSE;
    }

    /** Returns whether the next character is an apostrophe that precedes a word; such an apostrophe is ignored. */
    private boolean isApostropheBeforeWord() {
        return quoting
                && position < end
                && bytes[position] == '\''
                && (position + 1 == end || bytes[position + 1] != '(');
    }

    private void skipSpaceAndComments() {
        while (position < end) {
            byte next = bytes[position];
            if (next == ';') {
                skipComment();
            } else if (isSpace(next)) {
                position++;
            } else {
                return;
            }
        }
    }

    private void skipComment() {
        while (position < end && bytes[position] != '\n') {
            position++;
        }
    }

    private boolean endsAtom(byte character) {
        return character == '('
                || character == ')'
                || isSpace(character)
                || (quoting && (character == '"' || character == '\''));
    }

    private static boolean isSpace(byte character) {
        return character == ' ' || character == '\t' || character == '\n' || character == '\r';
    }
}

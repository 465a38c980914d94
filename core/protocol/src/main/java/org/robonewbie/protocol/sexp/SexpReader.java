package org.robonewbie.protocol.sexp;

import java.nio.charset.StandardCharsets;
import org.robonewbie.protocol.frame.MessageBuffer;

/**
 * Reads the S-expressions of one message token by token, straight from its bytes and without allocating.
 *
 * <p>The rules are those of SimSpark's own parser (sfsexp): blanks, tabs and line ends separate words, {@code ;} between words
 * begins a comment that extends to the end of the line, and a surplus closing parenthesis ends the message. Depth costs
 * nothing, so deeply nested input is harmless. Quotation marks are ordinary characters, as for SimSpark's clients, unless the
 * reader is created by {@link #withQuotes}, as for servers.
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
     * Creates a reader for what servers receive: {@code "two words"} is one atom without its quotation marks, within which a
     * backslash escapes the next character, and {@code '(a b)} is one atom too.
     *
     * @return a reader without a message
     */
    public static SexpReader withQuotes() {
        return new SexpReader(true);
    }

    /**
     * Starts at the beginning of a message, which must not change while it is read.
     *
     * @param message the message
     */
    public void start(MessageBuffer message) {
        start(message.bytes(), 0, message.length());
    }

    /**
     * Starts at a position within an array, which must not change while it is read.
     *
     * @param array holds the message
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
     * @return what was found; {@link Token#END} repeatedly at the end of the message
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
     * Skips tokens until no more than a number of lists are open. Does nothing if that is already so; stops at {@link
     * Token#END} if the message ends first.
     *
     * @param outerDepth how many lists stay open
     */
    public void skipTo(int outerDepth) {
        while (depth > outerDepth && next() != Token.END) {
            // each token advances the reader
        }
    }

    /**
     * Advances to the next list {@code (name …)} at a certain depth, skipping the rest of the previous list, words between the
     * lists and lists without a name. Afterwards the name is the current atom.
     *
     * <p>If there is none, the current token is {@link Token#CLOSE} if the enclosing list is complete, else {@link Token#END}.
     *
     * @param outerDepth how many lists enclose the wanted list; 0 for the lists of the message itself
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
     * Advances to the next token, which should be a number.
     *
     * @return whether it is one, so that {@link #number()} can be called
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
     * Reads the current atom as a number by the rules of C's {@code atof}: what follows a number is ignored, text that is not a
     * number counts as 0, and {@code nan} and {@code inf} are understood.
     *
     * @return the number, correctly rounded
     */
    public double number() {
        return decimals.parse(bytes, atomStart, atomEnd);
    }

    /**
     * Reads the current atom as an integer, truncating decimals as SimSpark does.
     *
     * @return the number, 0 if the atom is not a number
     */
    public int integer() {
        return (int) number();
    }

    /** {@return whether the current atom begins like a number; if not, {@link #number()} returns the default 0} */
    public boolean isNumber() {
        return decimals.isNumber(bytes, atomStart, atomEnd);
    }

    /** {@return a copy of the current atom as text} */
    public String text() {
        return new String(bytes, atomStart, atomEnd - atomStart, StandardCharsets.UTF_8);
    }

    /**
     * Returns the current atom as text without copying it if it equals an expected text; saves allocations where words repeat.
     *
     * @param known the text that is expected
     * @return {@code known} if it is the same text, else a copy of the atom
     */
    public String text(String known) {
        return atomIs(known) ? known : text();
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

    /** Reads a text in quotation marks; without its closing mark there is none, and nothing after it. */
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

    /** Reads the whole list after an apostrophe as it is written. */
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

    /** An apostrophe before a word changes nothing. */
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

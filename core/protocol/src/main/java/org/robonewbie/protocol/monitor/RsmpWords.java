package org.robonewbie.protocol.monitor;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.protocol.sexp.SexpReader;
import org.robonewbie.protocol.sexp.Token;

/** Reads the words of an RSMP message. A word that is not understood is named in the exception. */
final class RsmpWords {

    private static final int MAX_WORD_BYTES = 200;
    private static final int MAX_WORDS = 200;
    private static final int MAX_SHOWN = 30;

    /** Greatest absolute value of a number; no pitch and no match is that large. */
    private static final double MAX_NUMBER = 1e9;

    private final SexpReader in;

    RsmpWords(SexpReader in) {
        this.in = in;
    }

    void open() throws MalformedMessageException {
        if (in.next() != Token.OPEN) {
            throw unexpected("\"(\"");
        }
    }

    void close() throws MalformedMessageException {
        if (in.next() != Token.CLOSE) {
            throw unexpected("\")\"");
        }
    }

    String word(String meaning) throws MalformedMessageException {
        if (in.next() != Token.ATOM) {
            throw unexpected(meaning);
        }
        return text();
    }

    /** Returns the current word. */
    String text() throws MalformedMessageException {
        if (in.atomLength() > MAX_WORD_BYTES) {
            throw new MalformedMessageException("a word has " + in.atomLength() + " bytes; at most " + MAX_WORD_BYTES
                    + " are accepted: " + quoted());
        }
        return in.text();
    }

    double number(String meaning) throws MalformedMessageException {
        if (in.next() != Token.ATOM || !in.isDecimal()) {
            throw unexpected(meaning + ", a number");
        }
        double number = in.number();
        if (!(Math.abs(number) <= MAX_NUMBER)) {
            throw unexpected(meaning + ", a number");
        }
        return number;
    }

    int integer(String meaning, int min, int max) throws MalformedMessageException {
        double number = number(meaning);
        if (number != PortableMath.rint(number) || number < min || number > max) {
            throw unexpected(meaning + ", a whole number from " + min + " to " + max);
        }
        return (int) number;
    }

    /** Returns the current word and those after it, up to the end of their list. */
    List<String> list() throws MalformedMessageException {
        List<String> words = new ArrayList<>();
        String name = quoted();
        do {
            words.add(text());
            if (words.size() > MAX_WORDS) {
                throw new MalformedMessageException(
                        name + " has more than " + MAX_WORDS + " words, from " + quoted() + " on");
            }
        } while (in.next() == Token.ATOM);
        if (in.token() != Token.CLOSE) {
            throw unexpected("a word of " + name + " or \")\"");
        }
        return words;
    }

    /** Creates the exception for the current token. */
    MalformedMessageException unexpected(String expected) {
        return new MalformedMessageException("expected " + expected + ", found " + found());
    }

    private String found() {
        return switch (in.token()) {
            case OPEN -> "\"(\"";
            case CLOSE -> "\")\"";
            case END -> "the end of the message";
            case ATOM -> quoted();
        };
    }

    /** Returns the beginning of the current word in quotation marks. */
    String quoted() {
        String text = in.text();
        return '"' + (text.length() > MAX_SHOWN ? text.substring(0, MAX_SHOWN) + "…" : text) + '"';
    }
}

package org.robonewbie.protocol.sexp;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.robonewbie.protocol.frame.MessageBuffer;

class SexpReaderTest {

    private final SexpReader reader = new SexpReader();

    @Test
    void findsTokensInTheirOrder() {
        start("(time (now 93.60))");

        assertThat(tokens()).isEqualTo("OPEN time OPEN now 93.60 CLOSE CLOSE END");
    }

    @Test
    void takesAllKindsOfWhiteSpace() {
        start(" \t(a\r\n\tb)  ");

        assertThat(tokens()).isEqualTo("OPEN a b CLOSE END");
    }

    @Test
    void needsNoWhiteSpaceBetweenLists() {
        start("(GS(t 0)(pm PlayOn))");

        assertThat(tokens()).isEqualTo("OPEN GS OPEN t 0 CLOSE OPEN pm PlayOn CLOSE CLOSE END");
    }

    @Test
    void skipsCommentsToTheEndOfTheLine() {
        start("(a ; not (read\n b ;nor this)\n)");

        assertThat(tokens()).isEqualTo("OPEN a b CLOSE END");
    }

    @Test
    void semicolonWithinAWordIsPartOfIt() {
        start("(say a;b) (c)");

        assertThat(tokens()).isEqualTo("OPEN say a;b CLOSE OPEN c CLOSE END");
    }

    @Test
    void clientTakesQuotationMarksAsLetters() {
        start("(hear us 0.00 self it's) (a \"b)");

        assertThat(tokens()).isEqualTo("OPEN hear us 0.00 self it's CLOSE OPEN a \"b CLOSE END");
    }

    @Test
    void serverTakesTextInQuotationMarksAsOneAtom() {
        assertThat(quotedTokens("(teamname \"two (words\")(a\"b\"c)"))
                .isEqualTo("OPEN teamname two (words CLOSE OPEN a b c CLOSE END");
        assertThat(quotedTokens("(say \"a\\\"b\")")).isEqualTo("OPEN say a\\\"b CLOSE END");
    }

    @Test
    void serverTakesAListBehindAnApostropheAsOneAtom() {
        assertThat(quotedTokens("(a '(b (c)) d 'e)")).isEqualTo("OPEN a (b (c)) d e CLOSE END");
    }

    @Test
    void serverEndsAtAQuotationWithoutEnd() {
        assertThat(quotedTokens("(a)(b \"c)(d)")).isEqualTo("OPEN a CLOSE OPEN b END");
        assertThat(quotedTokens("(a)(b '(c)(d)")).isEqualTo("OPEN a CLOSE OPEN b (c) OPEN d CLOSE END");
        assertThat(quotedTokens("(a '((c)")).isEqualTo("OPEN a END");
        assertThat(quotedTokens("(a \"b\\")).isEqualTo("OPEN a END");
    }

    @Test
    void manyApostrophesDoNoHarm() {
        assertThat(quotedTokens("' ".repeat(100_000) + "a")).isEqualTo("a END");
    }

    @Test
    void endsAtASurplusClosingParenthesis() {
        start("(a))(b)");

        assertThat(tokens()).isEqualTo("OPEN a CLOSE END");
    }

    @Test
    void endsAgainAndAgain() {
        start("");

        assertThat(reader.next()).isEqualTo(Token.END);
        assertThat(reader.next()).isEqualTo(Token.END);
    }

    @Test
    void readsPartOfAnArray() {
        MessageBuffer message = message("xx(a)yy");

        reader.start(message.bytes(), 2, 5);

        assertThat(tokens()).isEqualTo("OPEN a CLOSE END");
    }

    @Test
    void comparesAtomsInPlace() {
        start("(HJ)");
        reader.next();
        reader.next();

        assertThat(reader.atomIs("HJ")).isTrue();
        assertThat(reader.atomIs("H")).isFalse();
        assertThat(reader.atomIs("HJK")).isFalse();
        assertThat(reader.atomIs("HK")).isFalse();
    }

    @Test
    void skipsTheRestOfAList() {
        start("(a (b (c) d) e)(f)");
        reader.next();
        reader.next();
        reader.next();

        reader.skipTo(1);

        assertThat(reader.token()).isEqualTo(Token.CLOSE);
        assertThat(reader.depth()).isEqualTo(1);
        assertThat(tokens()).isEqualTo("e CLOSE OPEN f CLOSE END");
    }

    @Test
    void findsTheListsAtOneDepth() {
        start("(See (B (pol 1)) word () ((x)) (L (pol 2)))(HJ)");
        assertThat(reader.nextList(0)).isTrue();
        assertThat(reader.text()).isEqualTo("See");

        assertThat(reader.nextList(1)).isTrue();
        assertThat(reader.text()).isEqualTo("B");
        assertThat(reader.nextList(1)).isTrue();
        assertThat(reader.text()).isEqualTo("L");
        assertThat(reader.nextList(1)).isFalse();
        assertThat(reader.token()).isEqualTo(Token.CLOSE);
        assertThat(reader.nextList(0)).isTrue();
        assertThat(reader.text()).isEqualTo("HJ");
        assertThat(reader.nextList(0)).isFalse();
    }

    @Test
    void saysWhenAListIsNotFinished() {
        start("(GS (t 1.0) (pm Play");
        reader.nextList(0);

        while (reader.nextList(1)) {
            // to the end
        }

        assertThat(reader.token()).isEqualTo(Token.END);
    }

    @Test
    void bearsAHundredThousandNestedParentheses() {
        start("(".repeat(100_000) + ")".repeat(100_000) + "(a)");

        assertThat(reader.nextList(0)).isTrue();
        assertThat(reader.text()).isEqualTo("a");
    }

    private void start(String text) {
        reader.start(message(text));
    }

    private static MessageBuffer message(String text) {
        MessageBuffer message = new MessageBuffer();
        message.append(text);
        return message;
    }

    private String tokens() {
        return tokens(reader);
    }

    private static String tokens(SexpReader from) {
        StringBuilder tokens = new StringBuilder();
        Token token;
        do {
            token = from.next();
            tokens.append(token == Token.ATOM ? from.text() : token).append(' ');
        } while (token != Token.END);
        return tokens.toString().strip();
    }

    private String quotedTokens(String text) {
        SexpReader server = SexpReader.withQuotes();
        server.start(message(text));
        return tokens(server);
    }
}

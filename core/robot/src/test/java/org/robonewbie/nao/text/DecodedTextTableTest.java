package org.robonewbie.nao.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.util.HexFormat;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Bytes of a table that the tests of the pages' scripts read as well, so that both readers agree. */
class DecodedTextTableTest {

    private static final HexFormat HEX = HexFormat.of();
    private static final String REFUSED = "refused";

    static Stream<List<String>> texts() {
        return Table.rows("decoded-texts.tsv").filter(row -> !row.get(2).equals(REFUSED));
    }

    static Stream<List<String>> refused() {
        return Table.rows("decoded-texts.tsv").filter(row -> row.get(2).equals(REFUSED));
    }

    @ParameterizedTest
    @MethodSource("texts")
    void readsTextAndGivesTheSameBytesBack(List<String> row) throws UndecodableTextException {
        byte[] bytes = HEX.parseHex(row.get(1));

        DecodedText text = DecodedText.of(bytes);

        assertThat(text.encoding() + (text.hasByteOrderMark() ? " with mark" : ""))
                .isEqualTo(row.get(2));
        assertThat(text.content()).isEqualTo(row.get(3));
        assertThat(text.note().orElse("-"))
                .isEqualTo(row.get(4).equals("-") ? "-" : row.get(4) + DecodedText.SAVE_AS_UTF_8);
        assertThat(text.encode(text.content())).isEqualTo(bytes);
        if (!row.get(6).equals("-")) {
            assertThat(text.encode(row.get(5))).isEqualTo(HEX.parseHex(row.get(6)));
        }
    }

    @ParameterizedTest
    @MethodSource("refused")
    void refusesWhatIsNoTextAndNamesTheLine(List<String> row) {
        assertThatExceptionOfType(UndecodableTextException.class)
                .isThrownBy(() -> DecodedText.of(HEX.parseHex(row.get(1))))
                .withMessage("line " + row.get(3) + " " + row.get(4) + ". " + DecodedText.SAVE_AS_UTF_8)
                .matches(problem -> problem.line() == Integer.parseInt(row.get(3)));
    }
}

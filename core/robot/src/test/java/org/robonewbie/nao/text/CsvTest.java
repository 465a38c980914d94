package org.robonewbie.nao.text;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class CsvTest {

    /** The scripts of the studio write the same cells, see {@code csv-cell.test.js}. */
    static Stream<String> cells() throws IOException {
        try (InputStream file = Objects.requireNonNull(CsvTest.class.getResourceAsStream("csv-cells.txt"))) {
            return new String(file.readAllBytes(), StandardCharsets.UTF_8).lines();
        }
    }

    @ParameterizedTest
    @MethodSource("cells")
    void textsThatSpreadsheetsWouldExecuteStayTexts(String line) {
        String[] parts = line.split(" \\| ?", -1);

        assertThat(Csv.cell(unescaped(parts[0]))).isEqualTo(unescaped(parts[1]));
    }

    @Test
    void linesEndAsSpreadsheetsWant() {
        assertThat(Csv.text(List.of(Csv.line(Stream.of("=a", "1")), "b"))).isEqualTo("'=a,1\r\nb\r\n");
    }

    private static String unescaped(String text) {
        return text.replace("\\|", "|")
                .replace("\\n", "\n")
                .replace("\\r", "\r")
                .replace("\\t", "\t")
                .replace("\\u00a0", "\u00a0")
                .replace("\\ufeff", "\ufeff");
    }
}

package org.robonewbie.learning.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.nao.file.UnreadableFileException;

class SearchFileTest {

    @TempDir
    Path folder;

    @Test
    void searchGoesOnFromWhatItHasFound() throws IOException {
        Path file = folder.resolve("coordinates.txt");
        CostFunction distance = (x, seed) -> Math.hypot(x[0] - 3, x[1] + 1);
        Search search = new Search(new SearchPlan(1, 0.5, 8, 15, 1, 1), distance);

        SearchFile.goOn(file, new double[] {0, 0}, search);
        double first = distance.cost(numbers(file), 0);
        SearchFile.goOn(file, new double[] {100, 100}, search);

        assertThat(first).isLessThan(1);
        assertThat(distance.cost(numbers(file), 0)).isLessThan(1);
    }

    @ParameterizedTest
    @CsvSource({
        "'1, x\n', 'line 1: \"x\" is no number.'",
        "'1\n2;1', 'line 2: \"2;1\" is no number.'",
        "'1, 2, 3', 'line 1: There are 3 numbers, and the search has 2.'",
        "'', 'line 1: There are 0 numbers, and the search has 2.'"
    })
    void fileThatDoesNotFitIsNamedWithItsLine(String text, String message) throws IOException {
        Path file = Files.writeString(folder.resolve("coordinates.txt"), text);
        Search search = new Search(new SearchPlan(1, 0.5, 8, 15, 1, 1), (x, seed) -> 0);

        assertThatThrownBy(() -> SearchFile.goOn(file, new double[] {0, 0}, search))
                .isInstanceOf(UnreadableFileException.class)
                .hasMessageStartingWith(file + ", " + message);
        assertThat(file).hasContent(text);
    }

    @ParameterizedTest
    @ValueSource(strings = {"UTF-8", "UTF-16LE"})
    void fileOfAnEditorIsRead(String encoding) throws IOException {
        Path file = Files.write(
                folder.resolve("coordinates.txt"), "\uFEFF3,\r\n-1\r\n".getBytes(Charset.forName(encoding)));
        List<Double> first = new ArrayList<>();
        Search search = new Search(new SearchPlan(1, 0.001, 8, 1, 1, 1), (x, seed) -> {
            synchronized (first) {
                first.add(x[0]);
            }
            return 0;
        });

        SearchFile.goOn(file, new double[] {0, 0}, search);

        assertThat(first).isNotEmpty().allMatch(x -> Math.abs(x - 3) < 0.1);
    }

    private static double[] numbers(Path file) throws IOException {
        String[] words = Files.readString(file).trim().split(", ", 2);
        return new double[] {Double.parseDouble(words[0]), Double.parseDouble(words[1])};
    }
}

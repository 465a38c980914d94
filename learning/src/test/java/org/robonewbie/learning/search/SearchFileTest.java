package org.robonewbie.learning.search;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

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

    private static double[] numbers(Path file) throws IOException {
        String[] words = Files.readString(file).trim().split(", ", 2);
        return new double[] {Double.parseDouble(words[0]), Double.parseDouble(words[1])};
    }
}

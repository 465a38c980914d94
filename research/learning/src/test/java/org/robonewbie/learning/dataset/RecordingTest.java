package org.robonewbie.learning.dataset;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RecordingTest {

    private static final RunVariation NONE = RunVariation.of(false, 0, 0, List.of());

    @TempDir
    private Path folder;

    private final List<String> lines = new ArrayList<>();

    @Test
    void programWithoutRobotsFailsItsRun() throws IOException {
        DataSet set = DataSet.create(folder, false, Map.of());

        new Recording(set, 1, 2, 1, 7, NONE).run(1, port -> Optional.of(""), lines::add);

        assertThat(lines)
                .containsExactly("run 1/1, seed 7: failed and is left out. The program did not connect 2 robots."
                        + " Pass their actual number with --robots.");
        assertThat(set.runs()).isZero();
        assertThat(folder.resolve("cycles")).isEmptyDirectory();
    }

    @Test
    void runThatTheUserHasEndedIsNotInTheTable() throws IOException {
        DataSet set = DataSet.create(folder, false, Map.of());

        new Recording(set, 1, 1, 1, 7, NONE).run(1, port -> Optional.empty(), lines::add);

        assertThat(lines).isEmpty();
        assertThat(set.failures()).isEmpty();
    }
}

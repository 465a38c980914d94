package org.robonewbie.workshop.motion;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MeasuredHeadersTest {

    private static final String NOD = "// does: nods\n200" + " 0".repeat(22) + "\n";

    @TempDir
    private Path folder;

    @Test
    void saysInTheFileHowWellTheMotionWorks() throws IOException {
        Path file = Files.writeString(folder.resolve("nod.txt"), NOD);
        MotionCheck check = new MotionCheck("nod", "stance", "nods", "s", seed -> new Outcome(seed != 1, 0.5));

        MeasuredHeaders.write(List.of(CheckResult.of(check, 0, 4)), folder);

        assertThat(Files.readString(file))
                .contains("// measured: 3 of 4 trials, mean 0.500 s; success: nods\n")
                .contains("// does: nods\n");
    }

    @Test
    void leavesOutWhatHasNoFile() throws IOException {
        MotionCheck check = new MotionCheck("walk engine", "stance", "walks", "m", seed -> new Outcome(true, 1));

        MeasuredHeaders.write(List.of(CheckResult.of(check, 0, 1)), folder);

        assertThat(folder).isEmptyDirectory();
    }
}

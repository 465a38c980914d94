package org.robonewbie.app.command;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What the program proposes can be copied into the terminal. */
class ProgramNameTest {

    @TempDir
    private Path folder;

    private String here(Path home, Path current, String searchPath, char separator) {
        return ProgramName.of(Optional.of(home), current, searchPath, separator)
                .in("Try: robonewbie grade kick --hint");
    }

    @Test
    void folderOfTheProgramIsNamedUnlessTheSystemFindsIt() throws IOException {
        Path work = folder.resolve("work");
        assumeThat(File.separatorChar).isEqualTo('/');

        assertThat(here(folder, folder, "/nowhere", '/')).isEqualTo("Try: ./robonewbie grade kick --hint");
        assertThat(here(folder, work, "/nowhere", '/')).isEqualTo("Try: ../robonewbie grade kick --hint");
        assertThat(Files.createFile(folder.resolve("robonewbie")).toFile().setExecutable(true))
                .isTrue();
        assertThat(here(folder, work, folder.toString(), '/')).isEqualTo("Try: robonewbie grade kick --hint");
    }

    @Test
    void windowsAndProgramsWithoutAHomeKeepTheBareName() {
        assertThat(here(folder, folder, "", '\\')).isEqualTo("Try: robonewbie grade kick --hint");
        assertThat(ProgramName.of(Optional.empty(), folder, "", '/').in("robonewbie run X"))
                .isEqualTo("robonewbie run X");
    }

    @Test
    void onlyCommandsAreChanged() {
        ProgramName word = new ProgramName("./robonewbie");

        assertThat(word.in("RoboNewbie, the folder .robonewbie and ./robonewbie run; robonewbie doctor"))
                .isEqualTo("RoboNewbie, the folder .robonewbie and ./robonewbie run; ./robonewbie doctor");
    }
}

package org.robonewbie.app;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** A release can be made from the project as it is. */
class ReleaseTest {

    private static final Pattern VERSION = Pattern.compile("(?m)^(?:  <version>|version = \")([0-9.]+)[<\"]");
    private static final Pattern UNPINNED = Pattern.compile("uses: .+@(?!\\p{XDigit}{40} # v\\d).*");

    @Test
    void javaAndPythonHaveTheSameVersion() throws IOException {
        assertThat(version("research/python/pyproject.toml")).isEqualTo(version("pom.xml"));
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void notesAreTheChangelogOfTheVersion() throws Exception {
        Process notes = new ProcessBuilder("release/notes", version("pom.xml"), "https://example.org/blob/v2")
                .directory(Project.ROOT.toFile())
                .start();

        assertThat(new String(notes.getInputStream().readAllBytes(), UTF_8))
                .contains("**Program a robot**", "](https://example.org/blob/v2/docs/")
                .doesNotContain("](docs/", "## ");
        assertThat(notes.waitFor()).isZero();
    }

    @Test
    void actionsOfWorkflowsArePinned() throws IOException {
        try (Stream<Path> workflows = Files.list(Project.ROOT.resolve(".github/workflows"))) {
            List<Path> files = workflows.toList();
            assertThat(files).isNotEmpty();
            for (Path file : files) {
                assertThat(file).content().doesNotContainPattern(UNPINNED);
            }
        }
    }

    private static String version(String file) throws IOException {
        return VERSION.matcher(Files.readString(Project.ROOT.resolve(file)))
                .results()
                .findFirst()
                .orElseThrow()
                .group(1);
    }
}

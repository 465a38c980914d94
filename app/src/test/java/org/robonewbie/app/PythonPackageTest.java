package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Runs the tests of the Python package, where Python with Gymnasium is installed. */
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "the launcher of this test is a shell script")
@Tag("slow")
class PythonPackageTest {

    private static final Path PACKAGE =
            Path.of("..", "research", "python").toAbsolutePath().normalize();

    @TempDir
    private Path scratch;

    @Test
    void packagePassesItsOwnTests() throws Exception {
        Python python = new Python(PACKAGE);
        python.skipWithout("gymnasium, numpy");
        Path launcher = scratch.resolve("robonewbie");
        Files.writeString(
                launcher,
                "#!/bin/sh\nexec \"" + Path.of(System.getProperty("java.home"), "bin", "java") + "\" -cp \""
                        + System.getProperty("java.class.path") + "\" org.robonewbie.app.Main \"$@\"\n");
        assertThat(launcher.toFile().setExecutable(true)).isTrue();

        Python.Result result = python.run(
                Map.of("ROBONEWBIE", launcher.toString(), "PYTHONPATH", PACKAGE.toString()),
                "-m",
                "unittest",
                "discover",
                "-s",
                "tests");

        assertThat(result.code()).as(result.printed()).isZero();
        assertThat(result.printed()).containsPattern("Ran \\d\\d tests").contains("OK");
    }
}

package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Runs the tests of the Python package, where Python with Gymnasium is installed. */
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "the launcher of this test is a shell script")
class PythonPackageTest {

    private static final Path PACKAGE = Path.of("..", "python").toAbsolutePath().normalize();

    @TempDir
    private Path scratch;

    @Test
    void packagePassesItsOwnTests() throws Exception {
        skipWithoutGymnasium();
        Path launcher = scratch.resolve("robonewbie");
        Files.writeString(
                launcher,
                "#!/bin/sh\nexec \"" + Path.of(System.getProperty("java.home"), "bin", "java") + "\" -cp \""
                        + System.getProperty("java.class.path") + "\" org.robonewbie.app.Main \"$@\"\n");
        assertThat(launcher.toFile().setExecutable(true)).isTrue();

        Result result = python(Map.of("ROBONEWBIE", launcher.toString()), "-m", "unittest", "discover", "-s", "tests");

        assertThat(result.code()).as(result.printed()).isZero();
        assertThat(result.printed()).containsPattern("Ran \\d\\d tests").contains("OK");
    }

    private void skipWithoutGymnasium() throws Exception {
        boolean usable = false;
        try {
            usable = python(Map.of(), "-c", "import gymnasium, numpy").code() == 0;
        } catch (IOException noPython) {
            // It is told below.
        }
        if (!usable && System.getenv("ROBONEWBIE_REQUIRE_TOOLS") != null) {
            throw new AssertionError(
                    "Python 3 with gymnasium is not installed, but ROBONEWBIE_REQUIRE_TOOLS asks for it.");
        }
        if (!usable) {
            System.out.println("SKIPPED: Python 3 with gymnasium is not installed, so the Python tests do not run.");
        }
        Assumptions.assumeTrue(usable, "Python 3 with gymnasium is not installed");
    }

    private record Result(int code, String printed) {}

    private Result python(Map<String, String> environment, String... arguments) throws Exception {
        Path output = scratch.resolve("output.txt");
        ProcessBuilder builder = new ProcessBuilder("python3")
                .directory(PACKAGE.toFile())
                .redirectErrorStream(true)
                .redirectOutput(output.toFile());
        builder.command().addAll(List.of(arguments));
        builder.environment().putAll(environment);
        builder.environment().put("PYTHONPATH", PACKAGE.toString());
        builder.environment().put("PYTHONDONTWRITEBYTECODE", "1");
        Process process = builder.start();
        assertThat(process.waitFor(5, TimeUnit.MINUTES)).as("Python ended").isTrue();
        return new Result(process.exitValue(), Files.readString(output, StandardCharsets.UTF_8));
    }
}

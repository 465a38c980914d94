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

/** Runs Python where it is installed. */
public record Python(Path folder) {

    /** What a program has printed, and how it ended. */
    public record Result(int code, String printed) {}

    /** Skips the test, aloud, where Python or one of the packages is missing, unless all tools are required. */
    public void skipWithout(String packages) throws Exception {
        boolean usable = false;
        try {
            usable = run(Map.of(), "-c", "import " + packages).code() == 0;
        } catch (IOException noPython) {
            // It is told below.
        }
        String missing = "Python 3 with " + packages + " is not installed";
        if (!usable && System.getenv("ROBONEWBIE_REQUIRE_TOOLS") != null) {
            throw new AssertionError(missing + ", but ROBONEWBIE_REQUIRE_TOOLS asks for it.");
        }
        if (!usable) {
            System.out.println("SKIPPED: " + missing + ", so this test does not run.");
        }
        Assumptions.assumeTrue(usable, missing);
    }

    /** Runs Python in the folder. */
    public Result run(Map<String, String> environment, String... arguments) throws Exception {
        Path output = Files.createTempFile("python", ".txt");
        try {
            ProcessBuilder builder = new ProcessBuilder("python3")
                    .directory(folder.toFile())
                    .redirectErrorStream(true)
                    .redirectOutput(output.toFile());
            builder.command().addAll(List.of(arguments));
            builder.environment().putAll(environment);
            builder.environment().put("PYTHONDONTWRITEBYTECODE", "1");
            Process process = builder.start();
            assertThat(process.waitFor(5, TimeUnit.MINUTES)).as("Python ended").isTrue();
            return new Result(process.exitValue(), Files.readString(output, StandardCharsets.UTF_8));
        } finally {
            Files.delete(output);
        }
    }
}

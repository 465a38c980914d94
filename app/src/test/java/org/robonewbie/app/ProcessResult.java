package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;

/** What a process has printed, and how it ended. */
public record ProcessResult(int code, String printed) {

    /** Only a process that hangs takes so long, whatever the load. */
    private static final int MAX_MINUTES = 15;

    /** Runs a process without input to its end. */
    public static ProcessResult of(ProcessBuilder builder) throws Exception {
        Path output = Files.createTempFile("process", ".txt");
        try {
            Process process = builder.redirectErrorStream(true)
                    .redirectOutput(output.toFile())
                    .start();
            process.getOutputStream().close();
            boolean ended = process.waitFor(MAX_MINUTES, TimeUnit.MINUTES);
            process.destroyForcibly();
            String printed = Files.readString(output, StandardCharsets.UTF_8);
            assertThat(ended).as("ended%n%s", printed).isTrue();
            return new ProcessResult(process.waitFor(), printed);
        } finally {
            Files.delete(output);
        }
    }
}

package org.robonewbie.learning.series;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;

class FirstExperimentTest {

    @Test
    void exampleTellsFiveTrials() {
        ByteArrayOutputStream printed = new ByteArrayOutputStream();
        PrintStream console = System.out;
        Locale locale = Locale.getDefault();
        System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
        Locale.setDefault(Locale.ROOT);

        try {
            FirstExperiment.main(new String[0]);
        } finally {
            System.setOut(console);
            Locale.setDefault(locale);
        }

        List<String> lines = printed.toString(StandardCharsets.UTF_8).lines().toList();
        assertThat(lines)
                .hasSize(5)
                .allMatch(line -> line.matches(
                        "\\d+ degrees per second: \\d\\.\\d\\d s on its feet, mean tilt \\d+\\.\\d degrees"));
    }

    @Test
    void documentShowsTheExampleAsItIs() throws IOException {
        String document = Files.readString(Path.of("../../docs/experiments.md"));
        String source = Files.readString(Path.of("src/test/java/org/robonewbie/learning/series/FirstExperiment.java"));

        String shown =
                document.substring(document.indexOf("public class FirstExperiment"), document.indexOf("\n```\n"));

        assertThat(source.replaceAll("\\s+", "")).contains(shown.replaceAll("\\s+", ""));
    }
}

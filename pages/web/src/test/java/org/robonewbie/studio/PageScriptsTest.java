package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** Unit tests and type checks of the static page's scripts, together with those of the studio. */
class PageScriptsTest {

    @Test
    void scriptsPassTheTypeCheck() throws IOException, InterruptedException {
        Path compiler = NodeTool.require("typescript/bin/tsc");

        run(Tool.NODE.orSkip().toString(), compiler.toString(), "--project", "jsconfig.json");
    }

    @Test
    void scriptsPassTheirTests() throws IOException, InterruptedException {
        run(Tool.NODE.orSkip().toString(), "--test", "src/test/javascript/");
    }

    private static void run(String... command) throws IOException, InterruptedException {
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);

        assertThat(process.waitFor()).as(said).isZero();
    }
}

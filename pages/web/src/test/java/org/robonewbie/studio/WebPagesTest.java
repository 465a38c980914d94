package org.robonewbie.studio;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Runs the tests of the compiled web edition in Chromium and Firefox. */
class WebPagesTest {

    @Test
    void webEditionPassesItsQuickTests() throws IOException, InterruptedException {
        run("quick");
    }

    @Tag("slow")
    @Test
    void webEditionPassesItsSlowTests() throws IOException, InterruptedException {
        run("slow");
    }

    private static void run(String tests) throws IOException, InterruptedException {
        String page = Path.of("target", "web").toAbsolutePath().toString();
        PageTestRunner.run("web", tests, Map.of("WEB_EDITION", page));
    }
}

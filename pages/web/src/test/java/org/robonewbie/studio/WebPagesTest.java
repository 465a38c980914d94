package org.robonewbie.studio;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Runs the tests of the compiled web edition in Chromium and Firefox. */
class WebPagesTest {

    private static final String PAGE = Path.of("target", "web").toAbsolutePath().toString();

    @Test
    void webEditionPassesItsQuickTests() throws IOException, InterruptedException {
        run("quick");
    }

    @Tag("slow")
    @Test
    void webEditionPassesItsSlowTests() throws IOException, InterruptedException {
        run("slow");
    }

    @Test
    void webEditionKeepsWorkAndRunsProgramsInFirefox() throws IOException, InterruptedException {
        Tool.FIREFOX.orSkip();

        PageTestRunner.run("web", "firefox", Map.of("WEB_EDITION", PAGE, "BROWSER", "firefox"));
    }

    private static void run(String tests) throws IOException, InterruptedException {
        PageTestRunner.run("web", tests, Map.of("WEB_EDITION", PAGE));
    }
}

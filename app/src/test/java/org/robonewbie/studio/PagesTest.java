package org.robonewbie.studio;

import java.io.IOException;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Runs the tests of the studio's rooms in Chromium. */
class PagesTest {

    @Test
    void roomsPassTheirQuickTests() throws IOException, InterruptedException {
        run("quick", "");
    }

    @Tag("slow")
    @Test
    void roomsPassTheirSlowTests() throws IOException, InterruptedException {
        run("slow", "");
    }

    /** Runs tests that keep their pictures in a folder; nowhere if its name is empty. */
    static void run(String tests, String pictures) throws IOException, InterruptedException {
        String classPath = System.getProperty("surefire.test.class.path", System.getProperty("java.class.path"));
        PageTestRunner.run("rooms", tests, Map.of("STAGE_CLASS_PATH", classPath, "PICTURES", pictures));
    }
}

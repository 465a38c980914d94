package org.robonewbie.studio;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Runs the tests of the studio's rooms in Chromium. */
class PagesTest {

    @Test
    void roomsPassTheirQuickTests() throws IOException, InterruptedException {
        run("quick");
    }

    @Tag("slow")
    @Test
    void roomsPassTheirSlowTests() throws IOException, InterruptedException {
        run("slow");
    }

    @Tag("picture")
    @Test
    void roomsGiveThePicturesOfTheDocumentation(@TempDir Path pictures) throws IOException, InterruptedException {
        run("picture", pictures.toString());
        try (DirectoryStream<Path> files = Files.newDirectoryStream(pictures)) {
            for (Path file : files) {
                Picture.ofDocumentation("docs/images/" + file.getFileName(), Files.readAllBytes(file));
            }
        }
    }

    private static void run(String tests) throws IOException, InterruptedException {
        run(tests, "");
    }

    /** Runs tests that keep their pictures in a folder; nowhere if its name is empty. */
    private static void run(String tests, String pictures) throws IOException, InterruptedException {
        String classPath = System.getProperty("surefire.test.class.path", System.getProperty("java.class.path"));
        PageTestRunner.run("rooms", tests, Map.of("STAGE_CLASS_PATH", classPath, "PICTURES", pictures));
    }
}

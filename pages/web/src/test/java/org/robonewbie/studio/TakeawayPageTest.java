package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import javax.tools.ToolProvider;
import org.assertj.core.api.Assumptions;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Export of programs from the static page: as a project in a zip file, and as a link. */
@InBrowser
@Timeout(300)
class TakeawayPageTest {

    private static final String OTHER = """
            import org.robonewbie.agent.Agent;

            public class Greeter extends Agent {
                public static void main(String[] args) {
                    new Greeter().run(args);
                }

                @Override
                protected void think() {
                    log.info("hello"); // or: grüße
                }
            }
            """;

    @TempDir
    private Path folder;

    private final Chromium browser;
    private StaticServer server;

    TakeawayPageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void open() throws IOException {
        server = new StaticServer(Path.of("target", "web").toAbsolutePath());
        openRoom("#program");
    }

    @AfterEach
    void end() {
        server.close();
    }

    @Test
    void downloadedProjectCompilesAndRuns() throws IOException, InterruptedException {
        Assumptions.assumeThat(Path.of("target", "web", "project", "project.json"))
                .content()
                .contains("\"robonewbie\"");
        browser.click("#program-save");
        browser.evaluate("fetch('api/programs/own/Second.java', { method: 'PUT', body: " + Chromium.quoted(OTHER)
                + " }).then(({ ok }) => ok)");
        Path zip = browser.download(folder, () -> browser.click("#program-zip"));
        assertThat(zip).hasFileName("my-robot.zip");

        Path project = unpacked(zip).resolve("my-robot");
        assertThat(project.resolve("src/main/java/myrobot"))
                .isDirectoryContaining("glob:**/MyAgent.java")
                .isDirectoryContaining("glob:**/Greeter.java");
        assertThat(project.resolve("src/main/java/myrobot/Greeter.java"))
                .content()
                .startsWith("package myrobot;")
                .contains("grüße");
        assertThat(compiled(project)).isZero();
        assertThat(run(project, "sh", "robonewbie", "run", "src/main/java/myrobot/MyAgent.java"))
                .contains("left shoulder 31.2 degrees");
        assertThat(run(project, "sh", "robonewbie", "run", "src/main/java/myrobot/Greeter.java"))
                .contains("hello");
    }

    /** Compiles as described in the project's README. */
    private static int compiled(Path project) throws IOException {
        try (Stream<Path> all = Files.walk(project)) {
            List<Path> files = all.toList();
            String jar = files.stream()
                    .map(Path::toString)
                    .filter(name -> name.matches(".*robonewbie-[^/]*(?<!-sources|-javadoc)\\.jar"))
                    .findFirst()
                    .orElseThrow();
            List<String> command = Stream.concat(
                            Stream.of(
                                    "-cp", jar, "-d", project.resolve("classes").toString()),
                            files.stream().map(Path::toString).filter(name -> name.matches(".*/src/main/.*\\.java")))
                    .toList();
            return ToolProvider.getSystemJavaCompiler().run(null, null, null, command.toArray(String[]::new));
        }
    }

    private static String run(Path project, String... command) throws IOException, InterruptedException {
        List<String> words = Stream.concat(
                        Stream.of(command), Stream.of("--headless", "--fast", "--seed", "1", "--seconds", "3"))
                .toList();
        Process program = new ProcessBuilder(words)
                .directory(project.toFile())
                .redirectErrorStream(true)
                .start();
        String said = new String(program.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(program.waitFor()).as(said).isZero();
        return said;
    }

    private static Path unpacked(Path zip) throws IOException {
        Path place = Files.createDirectory(zip.resolveSibling("unpacked"));
        try (ZipFile files = new ZipFile(zip.toFile())) {
            for (ZipEntry entry : files.stream().toList()) {
                Path file = place.resolve(entry.getName());
                Files.createDirectories(file.getParent());
                try (InputStream content = files.getInputStream(entry)) {
                    Files.copy(content, file);
                }
            }
        }
        return place;
    }

    @Test
    void linkHoldsTheProgram() {
        browser.evaluate("studio.rooms.program.editor.replace(" + Chromium.quoted(OTHER) + ")");
        browser.click("#program-link");
        browser.await("location.hash.includes('shared=')");
        String link = browser.evaluate("location.href").getAsString();
        browser.evaluate("localStorage.clear()");

        browser.visit("about:blank");
        browser.visit(link);
        browser.await("studio.rooms.program?.files?.file !== undefined");

        assertThat(browser.evaluate("studio.rooms.program.editor.text").getAsString())
                .isEqualTo(OTHER);
        assertThat(browser.evaluate("location.hash").getAsString()).isEqualTo("#program");
    }

    private void openRoom(String place) {
        browser.visit(server.address() + place);
        browser.await("studio.rooms.program?.files?.file !== undefined");
    }
}

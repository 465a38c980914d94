package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.file.MotionFiles;

/** Files are read and written below one folder only, and only for pages of the studio. */
class MotionAccessTest {

    @TempDir
    private Path place;

    private final TestSimulator simulation = new TestSimulator();
    private Path folder = Path.of(".");
    private StudioServer studio;
    private String cookie = "";

    @BeforeEach
    void start() throws IOException {
        folder = Files.createDirectory(place.resolve("motions"));
        Files.writeString(place.resolve("secret.txt"), "secret");
        studio = StudioServer.start(
                simulation.control(), 0, AccessToken.random(), new StudioFolders(folder, Optional.empty()));
        cookie = "Cookie: " + StudioCookie.of(studio.oneTimeAddress());
    }

    @AfterEach
    void close() {
        studio.close();
        simulation.close();
    }

    private String send(String order, String body, String... headers) throws IOException {
        List<String> lines = Stream.concat(
                        Stream.of(
                                order + " HTTP/1.1",
                                "Host: " + studio.address().getAuthority(),
                                "Content-Length: " + body.length()),
                        Stream.of(headers))
                .toList();
        String request = String.join("\r\n", lines) + "\r\nConnection: close\r\n\r\n" + body;
        return RawHttp.sendText(studio.address(), request);
    }

    private String asPage(String order, String body, String... headers) throws IOException {
        String[] all = Stream.concat(
                        Stream.of("Origin: http://" + studio.address().getAuthority(), cookie), Stream.of(headers))
                .toArray(String[]::new);
        return send(order, body, all);
    }

    @Test
    void fileIsWrittenAndReadBack() throws IOException {
        String answer = asPage("PUT /api/files/motion/my%20kick", "// hello\n");

        assertThat(answer).startsWith("HTTP/1.1 200");
        assertThat(folder.resolve("my kick.txt")).hasContent("// hello\n");
        assertThat(asPage("GET /api/files/motion/my%20kick", "")).endsWith("// hello\n");
        assertThat(asPage("GET /api/files/motion", "")).contains("\"path\":\"my kick\"");
        try (Stream<Path> files = Files.list(folder)) {
            assertThat(files).hasSize(1);
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "..%2fsecret",
                "%2e%2e%2fsecret",
                "..%5csecret",
                "..",
                "%2e%2e",
                ".hidden",
                "a%2fb",
                "%00",
                "a%00b",
                "con",
                "NUL",
                "%2fetc%2fpasswd",
                "..%252fsecret"
            })
    void namesThatLeadElsewhereAreRefused(String name) throws IOException {
        for (String repository : List.of("motion", "motion-draft", "motion-library")) {
            assertThat(asPage("GET /api/" + repository + "/" + name, ""))
                    .containsPattern("^HTTP/1.1 40[0-9]")
                    .doesNotContain("\r\n\r\nsecret");
            assertThat(asPage("PUT /api/" + repository + "/" + name, "evil")).containsPattern("^HTTP/1.1 40[0-9]");
        }
        assertThat(place.resolve("secret.txt")).hasContent("secret");
        try (Stream<Path> files = Files.walk(place)) {
            assertThat(files.filter(Files::isRegularFile)).hasSize(1);
        }
    }

    @Test
    void linkOutOfTheFolderIsRefused() throws IOException {
        Files.createSymbolicLink(folder.resolve("link.txt"), place.resolve("secret.txt"));

        assertThat(asPage("GET /api/files/motion/link", ""))
                .startsWith("HTTP/1.1 403")
                .contains("outside");
        assertThat(asPage("PUT /api/files/motion/link", "evil")).startsWith("HTTP/1.1 403");
        assertThat(asPage("GET /api/files/motion", ""))
                .contains("\"files\":[]", "\"link\\\" is a link to a place outside");
        assertThat(place.resolve("secret.txt")).hasContent("secret");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "grüßen",
                "приседание",
                "día",
                "挥手",
                "手\u3000を振る",
                "नमस्ते",
                "سلام",
                "wave (1)",
                "a+b",
                "it's & more",
                "#1; go!",
                "👋",
                "1st",
                "-x",
                "wave.v2",
                "नमस्ते करना दोनों हाथों से और फिर धीरे धीरे नीचे बैठना और उठना फिर से"
            })
    void motionMayBeCalledInAnyLanguage(String name) throws IOException {
        String encoded = URLEncoder.encode(name, StandardCharsets.UTF_8).replace("+", "%20");

        assertThat(asPage("PUT /api/files/motion/" + encoded, "// hello\n")).startsWith("HTTP/1.1 200");

        assertThat(folder.resolve(name + ".txt")).hasContent("// hello\n");
        assertThat(asPage("GET /api/files/motion/" + encoded, "")).endsWith("// hello\n");
        assertThat(new MotionFiles(folder).names()).containsExactly(name);
        assertThat(listed()).containsExactly(name);
        assertThat(MotionFiles.library(folder).find(name)).isPresent();
    }

    @Test
    void nameIsTheSameInEitherFormOfItsLetters() throws IOException {
        Path decomposed = Files.writeString(folder.resolve("gru\u0308ßen.txt"), "// mac\n");

        assertThat(listed()).containsExactly("grüßen");
        String version = asPage("GET /api/files/motion/gr%C3%BC%C3%9Fen", "");
        assertThat(version).endsWith("// mac\n");
        String known = version.replaceFirst("(?s).*\nVersion: (\\w+).*", "$1");
        assertThat(asPage("PUT /api/files/motion/gr%C3%BC%C3%9Fen", "// new\n", "Known-Version: " + known))
                .startsWith("HTTP/1.1 200");

        assertThat(decomposed).hasContent("// new\n");
        assertThat(listed()).containsExactly("grüßen");
    }

    @Test
    void invalidMotionFileIsSkipped() throws IOException, InterruptedException {
        Files.writeString(folder.resolve("good.txt"), "// good\n");
        Files.createDirectory(folder.resolve("folder.txt"));
        Files.createSymbolicLink(folder.resolve("dead.txt"), place.resolve("nowhere"));
        Files.createSymbolicLink(folder.resolve("zero.txt"), Path.of("/dev/zero"));
        Files.writeString(folder.resolve("what?.txt"), "// what\n");
        try (RandomAccessFile huge =
                new RandomAccessFile(folder.resolve("huge.txt").toFile(), "rw")) {
            huge.setLength(2_300_000_000L);
        }
        Path pipe = folder.resolve("pipe.txt");
        assertThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor())
                .isZero();

        String list = asPage("GET /api/files/motion", "");

        assertThat(listed()).containsExactly("good");
        assertThat(list)
                .contains("folder.txt is a folder", "dead.txt does not exist", "zero.txt is not a regular file")
                .contains("huge.txt is larger than 2 MB", "pipe.txt is not a regular file but a device or a pipe")
                .contains("The name of the file what?.txt contains \\\"?\\\"");
        for (String name : List.of("huge", "pipe", "folder")) {
            assertThat(asPage("GET /api/files/motion/" + name, ""))
                    .startsWith("HTTP/1.1 409")
                    .contains("The file ", name + ".txt is ");
            assertThat(asPage("PUT /api/files/motion/" + name, "evil")).startsWith("HTTP/1.1 409");
        }
    }

    private List<String> listed() throws IOException {
        String answer = asPage("GET /api/files/motion", "");
        JsonObject json = JsonParser.parseString(answer.substring(answer.indexOf("\r\n\r\n")))
                .getAsJsonObject();
        return json.getAsJsonArray("files").asList().stream()
                .map(entry -> entry.getAsJsonObject().get("path").getAsString())
                .toList();
    }

    @Test
    void pagesOfOthersMayNotChangeFiles() throws IOException {
        String put = "PUT /api/files/motion/evil";
        String own = "Origin: http://" + studio.address().getAuthority();

        assertThat(send(put, "x", cookie, "Origin: http://evil.example")).startsWith("HTTP/1.1 403");
        assertThat(send(put, "x", cookie))
                .startsWith("HTTP/1.1 403")
                .contains("Only pages of the studio may change files; this request has no Origin header.");
        assertThat(send(put, "x", own)).startsWith("HTTP/1.1 403").contains("is not signed in");
        assertThat(send(
                        put,
                        "x",
                        own,
                        "Cookie: robonewbie-studio-" + studio.address().getPort() + "=wrong"))
                .startsWith("HTTP/1.1 403");
        assertThat(send("GET /api/files/motion", "")).startsWith("HTTP/1.1 403");
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void fileThatAnotherProgramHasChangedIsNotOverwritten() throws IOException {
        String version = header(asPage("PUT /api/files/motion/mine", "a"), "Version");
        Files.writeString(folder.resolve("mine.txt"), "b");

        assertThat(asPage("PUT /api/files/motion/mine", "c", "Known-Version: " + version))
                .startsWith("HTTP/1.1 409")
                .contains("\"mine\" was changed by another program after it was opened here.");
        assertThat(asPage("PUT /api/files/motion/mine", "c"))
                .startsWith("HTTP/1.1 409")
                .contains("There is already a motion named \"mine\". Choose another name.");
        assertThat(folder.resolve("mine.txt")).hasContent("b");
    }

    @Test
    void fileThatIsTooLargeIsRefused() throws IOException {
        assertThat(send(
                        "PUT /api/files/motion/mine",
                        "",
                        "Origin: http://" + studio.address().getAuthority(),
                        cookie,
                        "Transfer-Encoding: chunked"))
                .containsPattern("^HTTP/1.1 4[0-9][0-9]");
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void draftsComeAndGo() throws IOException {
        asPage("PUT /api/files/motion-draft/mine", "draft");
        assertThat(asPage("GET /api/files/motion-draft/mine", "")).endsWith("draft");

        asPage("DELETE /api/files/motion-draft/mine", "");

        assertThat(asPage("GET /api/files/motion-draft/mine", ""))
                .startsWith("HTTP/1.1 404")
                .contains("There is no motion named \"mine\".");
    }

    @Test
    void everyMotionOfTheLibraryCanBeOpened() throws IOException {
        assertThat(asPage("GET /api/files/motion-library", "")).contains("\"wave\"", "\"walk-forward\"", "\"stand\"");
        String wave = asPage("GET /api/files/motion-library/wave", "");
        String content = wave.substring(wave.indexOf("\r\n\r\n") + 4);

        assertThat(MotionFile.parse("wave.txt", content).motion().keyframes()).hasSizeGreaterThan(2);
    }

    @Test
    void trialOfSomethingThatIsNoMotionSaysWhy() throws IOException {
        assertThat(asPage("POST /api/trial", "500 1 2\n"))
                .startsWith("HTTP/1.1 400")
                .contains("2 angles, expected 22");
        assertThat(asPage("POST /api/trial", "", "Start: flying"))
                .startsWith("HTTP/1.1 400")
                .contains("Unknown start position \"flying\". Choose standing, back or front.");
    }

    private static String header(String answer, String name) {
        return answer.lines()
                .filter(line -> line.startsWith(name + ": "))
                .map(line -> line.substring(name.length() + 2))
                .findFirst()
                .orElseThrow();
    }
}

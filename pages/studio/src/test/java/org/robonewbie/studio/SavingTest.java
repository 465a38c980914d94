package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URI;
import java.nio.ByteBuffer;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.stream.Stream;
import org.assertj.core.api.Assumptions;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Programs and motions are saved atomically, and no window overwrites unsaved changes of another one. */
@Timeout(60)
class SavingTest {

    private static final String PROGRAM = "files/program/MyAgent.java";
    private static final String DRAFT = "files/program-draft/MyAgent.java";

    @TempDir
    private Path folder;

    private FurnishedStudio studio;
    private String cookie = "";
    private String host = "";

    @BeforeEach
    void start() throws IOException {
        studio = new FurnishedStudio(folder);
        String address = studio.oneTimeAddress();
        cookie = StudioCookie.of(URI.create(address));
        host = URI.create(address).getAuthority();
    }

    @AfterEach
    void close() {
        studio.close();
    }

    private String send(String order, String place, String body, String... headers) throws IOException {
        List<String> lines = Stream.concat(
                        Stream.of(
                                order + " /api/" + place + " HTTP/1.1",
                                "Host: " + host,
                                "Origin: http://" + host,
                                "Cookie: " + cookie,
                                "Content-Length: " + body.length()),
                        Stream.of(headers))
                .toList();
        String request = String.join("\r\n", lines) + "\r\nConnection: close\r\n\r\n" + body;
        return RawHttp.sendText(URI.create("http://" + host + "/"), request);
    }

    private static String versionIn(String answer) {
        return answer.lines()
                .filter(line -> line.startsWith("Version: "))
                .findFirst()
                .orElseThrow()
                .substring("Version: ".length());
    }

    @Test
    void leftoversOfAKilledStudioAreIgnored() throws IOException {
        Files.writeString(folder.resolve("MyAgent.java.part"), "half a prog");
        Files.writeString(folder.resolve("mine.txt.part"), "half a mot");

        assertThat(send("GET", "programs", "")).doesNotContain(".part");
        assertThat(send("GET", "files/motion", "")).doesNotContain(".part");
        assertThat(send("PUT", PROGRAM, "// whole")).startsWith("HTTP/1.1 200");
        assertThat(folder.resolve("MyAgent.java")).hasContent("// whole");
    }

    @Test
    void writeErrorIsReportedAndTheOldFileIsKept() throws IOException {
        Files.writeString(folder.resolve("src"), "mine");

        assertThat(send("PUT", "files/program/src/main/java/A.java", "// second"))
                .startsWith("HTTP/1.1 500")
                .contains("The file " + folder.resolve("src/main/java/A.java") + " cannot be written: ");
        assertThat(folder.resolve("src")).hasContent("mine");
    }

    @Test
    void pipeAmongTheFilesIsRefusedAtOnce() throws Exception {
        Assumptions.assumeThat(mkfifo("Pipe.java") && mkfifo("pipe.txt")).isTrue();

        for (String place : new String[] {"files/program/Pipe.java", "files/motion/pipe"}) {
            assertThat(send("GET", place, "")).startsWith("HTTP/1.1 409").contains("a device or a pipe");
            assertThat(send("PUT", place, "x")).startsWith("HTTP/1.1 409");
        }
        assertThat(send("POST", "programs/run/Pipe.java", "")).startsWith("HTTP/1.1 409");
        assertThat(send("GET", "programs", "")).startsWith("HTTP/1.1 200").doesNotContain("Pipe");
    }

    private boolean mkfifo(String name) throws IOException, InterruptedException {
        return new ProcessBuilder("mkfifo", folder.resolve(name).toString())
                        .start()
                        .waitFor()
                == 0;
    }

    @Test
    void hugeFileIsRefusedAloneAndTheOthersAreListed() throws IOException {
        try (SeekableByteChannel file = Files.newByteChannel(
                folder.resolve("huge.txt"),
                StandardOpenOption.CREATE_NEW,
                StandardOpenOption.WRITE,
                StandardOpenOption.SPARSE)) {
            file.position(3_000_000_000L).write(ByteBuffer.wrap(new byte[1]));
        }

        assertThat(send("GET", "files/motion", "")).contains("\"mine\"").doesNotContain("\"huge\"");
        assertThat(send("GET", "files/motion/huge", ""))
                .startsWith("HTTP/1.1 409")
                .contains("is larger than 2 MB");
    }

    @Test
    void deletedFileIsReportedAndCanBeWrittenAgain() throws IOException {
        String version = versionIn(send("PUT", PROGRAM, "// first"));
        Files.delete(folder.resolve("MyAgent.java"));

        assertThat(send("PUT", PROGRAM, "// second", "Known-Version: " + version))
                .startsWith("HTTP/1.1 409")
                .contains("was deleted by another program");
        assertThat(send("PUT", PROGRAM, "// second", "Known-Version: ")).startsWith("HTTP/1.1 200");
    }

    @Test
    void draftOfAnotherWindowIsNeitherReplacedNorRemoved() throws IOException {
        String mine = versionIn(send("PUT", DRAFT, "// of one window"));

        assertThat(send("PUT", DRAFT, "// of the other", "Known-Version: ")).startsWith("HTTP/1.1 409");
        send("PUT", PROGRAM, "// of the other");
        send("DELETE", DRAFT, "", "Known-Version: 0123");

        assertThat(send("GET", DRAFT, "")).endsWith("// of one window");
        String longer = versionIn(send("PUT", DRAFT, "// of one window, longer", "Known-Version: " + mine));
        send("DELETE", DRAFT, "", "Known-Version: " + longer);
        assertThat(send("GET", DRAFT, "")).startsWith("HTTP/1.1 404");
    }

    @Test
    void draftThatIsGoneIsWrittenAgain() throws IOException {
        String version = versionIn(send("PUT", DRAFT, "// mine"));
        send("DELETE", DRAFT, "", "Known-Version: " + version);

        assertThat(send("PUT", DRAFT, "// mine, longer", "Known-Version: " + version))
                .startsWith("HTTP/1.1 200");
    }

    @Test
    void draftGoesWithItsSave() throws IOException {
        send("PUT", DRAFT, "// mine");

        send("PUT", PROGRAM, "// mine");

        assertThat(send("GET", DRAFT, "")).startsWith("HTTP/1.1 404");
    }
}

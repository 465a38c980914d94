package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Random;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.simulator.file.RecordingRepository;

/** Whatever the folders of recordings and scenes contain, a page receives valid data or an error message. */
class DamagedFilesTest {

    private static final int DAMAGED = 60;

    @TempDir
    private static Path place;

    private static final TestSimulator simulation = new TestSimulator();
    private static Path runs;
    private static byte[] whole;
    private static StudioServer studio;
    private static String cookie = "";

    @BeforeAll
    static void start() throws IOException {
        runs = Files.createDirectory(place.resolve("runs"));
        Path recording = runs.resolve("game.rec");
        RecordedRun.write(recording);
        whole = Files.readAllBytes(recording);
        StudioFolders folders =
                new StudioFolders(place.resolve("motions"), Optional.of(new RecordingRepository(runs, 1_000_000_000)));
        studio = StudioServer.start(simulation.control(), 0, AccessToken.random(), folders);
        cookie = StudioCookie.of(studio.oneTimeAddress());
    }

    @AfterAll
    static void close() {
        studio.close();
        simulation.close();
    }

    @Tag("slow")
    @Test
    void damagedRecordingYieldsItsValidPartOrAnError() throws IOException {
        for (int seed = 0; seed < DAMAGED; seed++) {
            Files.write(runs.resolve("packed " + seed + ".rec"), damaged(whole, seed));
            Files.write(runs.resolve("content " + seed + ".rec"), packed(damaged(unpacked(whole), seed)));
        }

        for (int seed = 0; seed < DAMAGED; seed++) {
            for (String kind : new String[] {"packed", "content"}) {
                String name = kind + "%20" + seed;
                for (String address : new String[] {"log/", "cards/", "index/", "pieces/", "notes/"}) {
                    assertIsData(order("GET", address + name), address + name);
                }
                assertIsData(order("POST", "start/" + name + "?moment=100"), "start/" + name);
            }
        }
        assertIsData(order("GET", "recordings"), "recordings");
    }

    @Test
    void recordingsAndNotesThatAreLinksToOtherPlacesAreNotServed() throws IOException {
        Path secret = Files.writeString(place.resolve("secret"), "hush\n");
        Files.createSymbolicLink(runs.resolve("link.rec"), secret);
        Files.createSymbolicLink(runs.resolve("game.notes"), secret);

        assertThat(order("GET", "recordings")).contains("game").doesNotContain("link");
        assertThat(order("GET", "log/link")).startsWith("HTTP/1.1 404");
        assertThat(order("GET", "notes/game")).startsWith("HTTP/1.1 200").doesNotContain("hush");
    }

    @ParameterizedTest
    @ValueSource(strings = {"CON", "LPT1", "NUL.x", "COM%C2%B9", "goal.", "goal%20"})
    void unportableNamesAreRefused(String name) throws IOException {
        assertThat(order("PUT", "scenes/" + name)).startsWith("HTTP/1.1 409").contains("A scene cannot be named");
        assertThat(order("PUT", "recordings/" + name + "?was=game"))
                .startsWith("HTTP/1.1 409")
                .contains("A recording cannot be named");
    }

    private static void assertIsData(String answer, String what) {
        assertThat(answer).as(what).matches("(?s)HTTP/1.1 (200|409).*");
        if (!answer.startsWith("HTTP/1.1 200")) {
            assertThat(answer)
                    .as(what)
                    .contains("Content-Type: text/plain")
                    .endsWith(".")
                    .doesNotContain("Exception", "Index ", "For input string");
        }
    }

    private static byte[] damaged(byte[] bytes, int seed) {
        Random random = new Random(seed);
        byte[] changed = bytes.clone();
        for (int i = 0; i < 3; i++) {
            changed[random.nextInt(changed.length)] = (byte) random.nextInt();
        }
        return changed;
    }

    private static byte[] unpacked(byte[] bytes) throws IOException {
        return new GZIPInputStream(new ByteArrayInputStream(bytes)).readAllBytes();
    }

    private static byte[] packed(byte[] bytes) throws IOException {
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (GZIPOutputStream out = new GZIPOutputStream(packed)) {
            out.write(bytes);
        }
        return packed.toByteArray();
    }

    private static String order(String method, String address) throws IOException {
        String host = studio.address().getAuthority();
        return RawHttp.send(
                        studio.address(),
                        method + " /api/" + address + " HTTP/1.1",
                        "Host: " + host,
                        "Cookie: " + cookie,
                        "Origin: http://" + host,
                        "Content-Length: 0")
                .strip();
    }
}

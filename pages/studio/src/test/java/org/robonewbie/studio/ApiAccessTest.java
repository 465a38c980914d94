package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.simulator.file.RecordingRepository;
import org.robonewbie.studio.service.PageRequest;

/** Endpoints below {@code /api/} answer only pages of the studio, and no name leads out of its folder. */
class ApiAccessTest {

    @TempDir
    private static Path place;

    private static final TestSimulator simulation = new TestSimulator();
    private static StudioServer studio;
    private static String cookie = "";

    @BeforeAll
    static void start() throws IOException {
        Path runs = Files.createDirectory(place.resolve("runs"));
        RecordedRun.write(runs.resolve("game.rec"));
        RecordedRun.write(place.resolve("secret.rec"));
        for (Path notes : new Path[] {runs.resolve("game.notes"), place.resolve("secret.notes")}) {
            Files.writeString(notes, "{\"seconds\":1,\"robot\":\"A 1\",\"level\":\"INFO\",\"text\":\"hush\"}\n");
        }
        RecordingRepository repository = new RecordingRepository(runs, 1_000_000_000);
        StudioFolders folders = new StudioFolders(place.resolve("motions"), Optional.of(repository));
        studio = StudioServer.start(simulation.control(), 0, AccessToken.random(), folders);
        cookie = "Cookie: " + StudioCookie.of(studio.oneTimeAddress());
    }

    @AfterAll
    static void close() {
        studio.close();
        simulation.close();
    }

    private static Stream<String> readingRequests() {
        return requests().filter(order -> order.startsWith("GET "));
    }

    private static Stream<String> changingRequests() {
        return requests().filter(order -> !order.startsWith("GET "));
    }

    private static Stream<String> requests() {
        return Arrays.stream(PageRequest.values())
                .map(each -> each.toString()
                        .replace(" ", " /api/")
                        .replace("KIND", "motion")
                        .replace("PATH", "MyAgent.java")
                        .replace("robot/NAME", "robot/T1")
                        .replace("NAME", "game"));
    }

    @ParameterizedTest
    @MethodSource("readingRequests")
    void onlyPagesOfTheStudioAreAnswered(String order) throws IOException {
        assertThat(ask(order, host(), cookie)).startsWith("HTTP/1.1 ").doesNotStartWith("HTTP/1.1 403");
        assertThat(ask(order, "evil.example", cookie))
                .startsWith("HTTP/1.1 403")
                .contains("not to \"evil.example\"");
        assertThat(ask(order, host(), cookie, "Origin: http://evil.example"))
                .startsWith("HTTP/1.1 403")
                .contains("Pages from \"http://evil.example\" may not use the studio.");
        for (String site : new String[] {"cross-site", "same-site"}) {
            assertThat(ask(order, host(), cookie, "Sec-Fetch-Site: " + site))
                    .startsWith("HTTP/1.1 403")
                    .contains("Pages from other addresses may not use the studio.");
        }
        assertThat(ask(order, host())).startsWith("HTTP/1.1 403").contains("This browser is not signed in");
        assertThat(ask(order, host(), cookie + "0"))
                .startsWith("HTTP/1.1 403")
                .contains("This browser is not signed in");
    }

    @ParameterizedTest
    @MethodSource("changingRequests")
    void requestsWithoutOriginChangeNothing(String order) throws IOException {
        assertThat(ask(order, host(), cookie, "Content-Length: 0"))
                .startsWith("HTTP/1.1 403")
                .contains("Only pages of the studio may change files; this request has no Origin header.");
        assertThat(ask(order, host(), "Origin: http://" + host(), "Content-Length: 0"))
                .startsWith("HTTP/1.1 403")
                .contains("This browser is not signed in");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"..%2fsecret", "%2e%2e%2fsecret", "..%5csecret", "../secret", "..", "%00", "%2fetc%2fpasswd"})
    void namesOfRunsThatLeadElsewhereAreNotFound(String name) throws IOException {
        for (String repository : new String[] {"notes", "index", "cards", "pieces", "log"}) {
            assertThat(ask("GET /api/" + repository + "/" + name, host(), cookie))
                    .containsPattern("^HTTP/1.1 40[0-9]")
                    .doesNotContain("hush");
        }
        String start = "POST /api/start/" + name + "?moment=1";
        assertThat(ask(start, host(), cookie, "Origin: http://" + host(), "Content-Length: 0"))
                .containsPattern("^HTTP/1.1 40[0-9]");
    }

    private static String host() {
        return studio.address().getAuthority();
    }

    private static String ask(String order, String host, String... headers) throws IOException {
        String[] lines = new String[headers.length + 2];
        lines[0] = order + " HTTP/1.1";
        lines[1] = "Host: " + host;
        System.arraycopy(headers, 0, lines, 2, headers.length);
        return RawHttp.send(studio.address(), lines);
    }
}

package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.simulator.file.RecordingRepository;

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

    @ParameterizedTest
    @ValueSource(
            strings = {
                "GET /api/notes/game",
                "GET /api/recordings",
                "GET /api/index/game",
                "GET /api/cards/game",
                "GET /api/pieces/game",
                "GET /api/log/game",
                "GET /api/models",
                "GET /api/robot",
                "GET /api/motions",
                "GET /api/library/wave",
                "GET /api/poses",
                "GET /api/scenes",
                "GET /api/programs",
            })
    void onlyPagesOfTheStudioAreAnswered(String order) throws IOException {
        assertThat(ask(order, host(), cookie)).startsWith("HTTP/1.1 200");
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
    @ValueSource(
            strings = {
                "PUT /api/poses",
                "PUT /api/motions/mine",
                "DELETE /api/drafts/mine",
                "POST /api/trial",
                "PUT /api/scenes/mine",
                "POST /api/scenes/mine",
                "DELETE /api/scenes/mine",
                "POST /api/start/game?moment=1",
                "PUT /api/recordings/game?was=other",
                "DELETE /api/recordings/game",
                "PUT /api/stars/game",
                "PUT /api/bookmarks/game?seconds=1",
                "PUT /api/programs/own/MyAgent.java",
                "PUT /api/programs/draft/MyAgent.java",
                "DELETE /api/programs/draft/MyAgent.java",
                "POST /api/programs/check/MyAgent.java",
                "POST /api/programs/complete/MyAgent.java?at=1",
                "POST /api/programs/run/MyAgent.java?world=keep",
                "DELETE /api/programs/run",
            })
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

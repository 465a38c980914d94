package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.NetworkInterface;
import java.net.Socket;
import java.net.URI;
import java.util.List;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class StudioAccessTest {

    private static final AccessToken TOKEN = AccessToken.random();

    private static final SmallSimulation simulation = new SmallSimulation();
    private static final StudioServer studio = open();

    private static final StudioServer open() {
        try {
            return StudioServer.start(simulation, 0, TOKEN);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @BeforeAll
    static void startSimulation() {
        simulation.start();
    }

    @AfterAll
    static void close() {
        studio.close();
        simulation.close();
    }

    @Test
    void addressNamesThisComputerAndCarriesTheToken() {
        assertThat(studio.address().toString())
                .isEqualTo("http://127.0.0.1:" + studio.address().getPort() + "/?token=" + TOKEN.text());
    }

    @Test
    void startPageIsServed() throws IOException {
        String answer = get("/", host());

        assertThat(answer).startsWith("HTTP/1.1 200").contains("text/html").contains("RoboNewbie Studio");
    }

    @ParameterizedTest
    @ValueSource(strings = {"/main.js", "/theme.css", "/icon.svg", "/vendor/three/three.core.min.js"})
    void filesOfThePageAreServed(String path) throws IOException {
        assertThat(get(path, host())).startsWith("HTTP/1.1 200").contains("Cache-Control: no-cache");
    }

    @Test
    void unchangedFileIsNotSentAgain() throws IOException {
        String first = get("/theme.css", host());
        String tag = first.lines()
                .filter(line -> line.startsWith("ETag: "))
                .findFirst()
                .orElseThrow()
                .substring("ETag: ".length());

        String second =
                RawHttp.send(studio.address(), "GET /theme.css HTTP/1.1", "Host: " + host(), "If-None-Match: " + tag);

        assertThat(second).startsWith("HTTP/1.1 304").endsWith("\r\n\r\n");
        assertThat(RawHttp.send(
                        studio.address(), "GET /theme.css HTTP/1.1", "Host: " + host(), "If-None-Match: \"other\""))
                .startsWith("HTTP/1.1 200");
    }

    @Test
    void startPageNamesAllScriptsThatItNeeds() throws IOException {
        assertThat(get("/", host()))
                .contains("<link rel=\"modulepreload\" href=\"main.js\">")
                .contains("<link rel=\"modulepreload\" href=\"state/studio-state.js\">")
                .doesNotContain("motion-room.js");
    }

    @Test
    void pagesMayLoadFromThisServerOnly() throws IOException {
        assertThat(get("/", host()))
                .contains("Content-Security-Policy: default-src 'none'; script-src 'self' 'sha256-")
                .contains("Referrer-Policy: no-referrer")
                .contains("X-Content-Type-Options: nosniff");
    }

    @Test
    void headOfAFileComesWithoutItsContent() throws IOException {
        String answer = RawHttp.send(studio.address(), "HEAD /theme.css HTTP/1.1", "Host: " + host());

        assertThat(answer).startsWith("HTTP/1.1 200").endsWith("\r\n\r\n");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "/../AccessToken.class",
                "/%2e%2e/AccessToken.class",
                "/vendor/../../AccessToken.class",
                "/..%2fAccessToken.class",
                "/vendor/%2e%2e%2f%2e%2e%2fAccessToken.class",
                "/..\\AccessToken.class",
                "//etc/passwd",
                "/vendor/three/LICENSE",
                "/vendor",
                "/missing.js"
            })
    void nothingOutsideOfTheWebFolderIsServed(String path) throws IOException {
        assertThat(get(path, host())).containsPattern("^HTTP/1.1 40[0-9]");
    }

    @ParameterizedTest
    @ValueSource(strings = {"evil.example", "127.0.0.1:1", "127.0.0.1", "localhost", "[::1]:80"})
    void foreignHostNamesAreRefused(String host) throws IOException {
        assertThat(get("/", host)).startsWith("HTTP/1.1 403").contains("not to \"" + host + "\"");
    }

    @ParameterizedTest
    @ValueSource(strings = {"http://evil.example", "null", "https://127.0.0.1"})
    void foreignPagesMayNotReadFiles(String origin) throws IOException {
        String answer = RawHttp.send(studio.address(), "GET / HTTP/1.1", "Host: " + host(), "Origin: " + origin);

        assertThat(answer)
                .startsWith("HTTP/1.1 403")
                .contains("Pages of \"" + origin + "\" may not talk to the studio.");
    }

    @ParameterizedTest
    @ValueSource(strings = {"POST", "PUT", "DELETE", "OPTIONS"})
    void filesCannotBeChanged(String method) throws IOException {
        String answer = RawHttp.send(
                studio.address(), method + " /index.html HTTP/1.1", "Host: " + host(), "Content-Length: 0");

        assertThat(answer).startsWith("HTTP/1.1 403").contains("but not changed with " + method);
    }

    @Test
    void liveFeedIsRefusedWithoutToken() throws IOException {
        assertThat(upgrade("/live", "http://" + host()))
                .startsWith("HTTP/1.1 403")
                .contains("The access token is missing or wrong. Open the address that the simulator has printed.");
    }

    @Test
    void liveFeedIsRefusedWithAWrongToken() throws IOException {
        assertThat(upgrade("/live?token=" + AccessToken.random().text(), "http://" + host()))
                .startsWith("HTTP/1.1 403")
                .contains("token is missing or wrong");
    }

    @Test
    void liveFeedIsRefusedToForeignPages() throws IOException {
        assertThat(upgrade("/live?token=" + TOKEN.text(), "http://evil.example"))
                .startsWith("HTTP/1.1 403")
                .contains("Pages of \"http://evil.example\" may not talk to the studio.");
    }

    @Test
    void liveFeedIsRefusedWithoutOrigin() throws IOException {
        String answer = RawHttp.send(studio.address(), upgradeLines("/live?token=" + TOKEN.text()));

        assertThat(answer).startsWith("HTTP/1.1 403").contains("Only a page of the studio may watch the simulation");
    }

    @Test
    void otherComputersCannotConnect() throws IOException {
        List<InetAddress> others = NetworkInterface.networkInterfaces()
                .flatMap(NetworkInterface::inetAddresses)
                .filter(address -> address instanceof Inet4Address && !address.isLoopbackAddress())
                .toList();

        for (InetAddress address : others) {
            assertThatThrownBy(() -> new Socket(address, studio.address().getPort()).close())
                    .isInstanceOf(IOException.class);
        }
        assertThat(InetAddress.getByName(studio.address().getHost()).isLoopbackAddress())
                .isTrue();
    }

    @Test
    void takenPortIsToldWithWhatToDo() {
        int port = studio.address().getPort();

        assertThatThrownBy(() -> StudioServer.start(simulation, port, TOKEN))
                .isInstanceOf(IOException.class)
                .hasMessage("The studio cannot use port " + port + " of 127.0.0.1; probably another program uses it. "
                        + "End that program, or choose another port (0 = any free one).");
    }

    private static String host() {
        return URI.create(studio.address().toString()).getAuthority();
    }

    private static String get(String path, String host) throws IOException {
        return RawHttp.send(studio.address(), "GET " + path + " HTTP/1.1", "Host: " + host);
    }

    private static String upgrade(String path, String origin) throws IOException {
        String[] lines = upgradeLines(path);
        lines[lines.length - 1] += "\r\nOrigin: " + origin;
        return RawHttp.send(studio.address(), lines);
    }

    private static String[] upgradeLines(String path) {
        return new String[] {
            "GET " + path + " HTTP/1.1",
            "Host: " + host(),
            "Upgrade: websocket",
            "Connection: Upgrade",
            "Sec-WebSocket-Version: 13",
            "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA=="
        };
    }
}

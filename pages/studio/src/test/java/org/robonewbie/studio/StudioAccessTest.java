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
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class StudioAccessTest {

    private static final AccessToken TOKEN = AccessToken.random();

    private static final TestSimulator simulation = new TestSimulator();
    private static final StudioServer studio = open();

    private static final StudioServer open() {
        try {
            return StudioServer.start(simulation.control(), 0, TOKEN);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @AfterAll
    static void close() {
        studio.close();
        simulation.close();
    }

    @Test
    void printedAddressNamesThisComputerAndHoldsNoSecretThatLasts() {
        assertThat(studio.oneTimeAddress().toString())
                .matches("http://127\\.0\\.0\\.1:" + studio.address().getPort() + "/\\?code=[0-9a-f]{32}")
                .doesNotContain(TOKEN.text(), TOKEN.secretOf(studio.address().getPort()));
    }

    @Test
    void addressIsExchangedForACookieOnceAndReplaced() throws IOException {
        String address = "/wall.html?theme=dark&" + studio.oneTimeAddress().getQuery() + "&quality=low";

        assertThat(get(address, host()))
                .startsWith("HTTP/1.1 303")
                .contains("Location: http://" + host() + "/wall.html?theme=dark&quality=low\r\n")
                .contains("Set-Cookie: robonewbie-studio-" + studio.address().getPort() + "=")
                .contains("Cache-Control: no-store")
                .contains("Referrer-Policy: no-referrer");
        assertThat(get(address, host()))
                .startsWith("HTTP/1.1 403")
                .contains("This address has already been used", "press <kbd>Enter</kbd>", "Cache-Control: no-store")
                .doesNotContain("Set-Cookie", studio.oneTimeAddress().getQuery());
    }

    @Test
    void usedAddressOfABrowserThatIsInLeadsToThePage() throws IOException {
        URI address = studio.oneTimeAddress();
        String cookie = StudioCookie.of(address);

        assertThat(RawHttp.send(
                        studio.address(),
                        "GET /?" + address.getQuery() + " HTTP/1.1",
                        "Host: " + host(),
                        "Cookie: other=1; " + cookie))
                .startsWith("HTTP/1.1 303")
                .contains("Location: http://" + host() + "/\r\n");
    }

    @ParameterizedTest
    @ValueSource(strings = {"HEAD", "POST"})
    void onlyAVisitUsesAnAddressUp(String method) throws IOException {
        URI address = studio.oneTimeAddress();

        RawHttp.send(
                studio.address(),
                method + " /?" + address.getQuery() + " HTTP/1.1",
                "Host: " + host(),
                "Content-Length: 0");

        assertThat(StudioCookie.of(address)).startsWith("robonewbie-studio-");
    }

    @Test
    void addressUnderAForeignNameIsRefusedAndNotUsedUp() throws IOException {
        URI address = studio.oneTimeAddress();

        assertThat(get("/?" + address.getQuery(), "evil.example"))
                .startsWith("HTTP/1.1 403")
                .doesNotContain("Set-Cookie");
        assertThat(StudioCookie.of(address)).startsWith("robonewbie-studio-");
    }

    @ParameterizedTest
    @ValueSource(strings = {"//evil.example/", "/%5cevil.example/", "/%0d%0aSet-Cookie:%20a=b"})
    void redirectStaysOnThisServer(String path) throws IOException {
        String answer = get(path + "?" + studio.oneTimeAddress().getQuery(), host());

        assertThat(answer.lines())
                .noneMatch(
                        line -> line.startsWith("Location: ") && !line.startsWith("Location: http://" + host() + "/"))
                .noneMatch(line -> line.startsWith("Set-Cookie: a=b"));
    }

    @Test
    void studioBesideAnotherOneLetsItsBrowsersIn() throws IOException {
        String cookie = StudioCookie.of(studio.oneTimeAddress());

        try (StudioServer beside = StudioServer.startBeside(simulation.control(), studio);
                StudioServer stranger = StudioServer.start(simulation.control(), 0, TOKEN)) {
            assertThat(robotOf(beside, cookie)).startsWith("HTTP/1.1 200");
            assertThat(robotOf(stranger, cookie)).startsWith("HTTP/1.1 403");
            assertThat(robotOf(stranger, cookie + "; " + StudioCookie.of(stranger.oneTimeAddress())))
                    .startsWith("HTTP/1.1 200");
        }
    }

    @Test
    void cookiesOfManyOtherPortsDoNotLockABrowserOut() throws IOException {
        String others = ("robonewbie-studio-12345=" + TOKEN.text() + "; ").repeat(180);

        assertThat(robotOf(studio, others + StudioCookie.of(studio.oneTimeAddress())))
                .startsWith("HTTP/1.1 200");
    }

    private static String robotOf(StudioServer server, String cookie) throws IOException {
        return RawHttp.send(
                server.address(),
                "GET /api/robot HTTP/1.1",
                "Host: " + server.address().getAuthority(),
                "Cookie: " + cookie);
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

        assertThat(answer).startsWith("HTTP/1.1 403").contains("Pages from \"" + origin + "\" may not use the studio.");
    }

    @ParameterizedTest
    @ValueSource(strings = {"POST", "PUT", "DELETE", "OPTIONS"})
    void filesCannotBeChanged(String method) throws IOException {
        String answer = RawHttp.send(
                studio.address(), method + " /index.html HTTP/1.1", "Host: " + host(), "Content-Length: 0");

        assertThat(answer).startsWith("HTTP/1.1 403").contains("read-only: " + method);
    }

    @Test
    void liveFeedIsRefusedWithoutCookie() throws IOException {
        assertThat(upgrade("/live", "http://" + host(), ""))
                .startsWith("HTTP/1.1 403")
                .contains("This browser is not signed in", "Press Enter in the terminal");
    }

    @Test
    void liveFeedIsRefusedWithAWrongCookieAndWithACode() throws IOException {
        String cookie = StudioCookie.of(studio.oneTimeAddress());
        String wrong = cookie.substring(0, cookie.indexOf('=') + 1) + TOKEN.text();

        assertThat(upgrade("/live", "http://" + host(), wrong)).startsWith("HTTP/1.1 403");
        assertThat(upgrade("/live?" + studio.oneTimeAddress().getQuery(), "http://" + host(), ""))
                .startsWith("HTTP/1.1 403");
    }

    @Test
    void liveFeedIsRefusedToForeignPages() throws IOException {
        String cookie = StudioCookie.of(studio.oneTimeAddress());

        assertThat(upgrade("/live", "http://evil.example", cookie))
                .startsWith("HTTP/1.1 403")
                .contains("Pages from \"http://evil.example\" may not use the studio.");
    }

    @Test
    void liveFeedIsRefusedWithoutOrigin() throws IOException {
        String answer = RawHttp.send(studio.address(), upgradeLines("/live"));

        assertThat(answer).startsWith("HTTP/1.1 403").contains("Only pages of the studio may watch the simulation");
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
    void usedPortIsReportedWithAdvice() {
        int port = studio.address().getPort();

        assertThatThrownBy(() -> StudioServer.start(simulation.control(), port, TOKEN))
                .isInstanceOf(IOException.class)
                .hasMessage(
                        "The studio cannot use port " + port + " of 127.0.0.1; another program is probably using it. "
                                + "Stop that program, or choose another port (0 = any free one).");
    }

    private static String host() {
        return URI.create(studio.address().toString()).getAuthority();
    }

    private static String get(String path, String host) throws IOException {
        return RawHttp.send(studio.address(), "GET " + path + " HTTP/1.1", "Host: " + host);
    }

    private static String upgrade(String path, String origin, String cookie) throws IOException {
        String[] lines = upgradeLines(path);
        lines[lines.length - 1] += "\r\nOrigin: " + origin + (cookie.isEmpty() ? "" : "\r\nCookie: " + cookie);
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

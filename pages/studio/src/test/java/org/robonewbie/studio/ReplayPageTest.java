package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.simulator.file.RecordingRepository;

/** The replay in a real browser with a recording of the real simulator. */
@InBrowser
class ReplayPageTest {

    private static final String STATE = "studio.replay.state";
    private final Chromium browser;

    @TempDir
    private static Path recorded;

    @TempDir
    private Path place;

    private final TestSimulator simulation = new TestSimulator().withRobot();
    private StudioServer studio;

    ReplayPageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void open() throws IOException {
        for (String file : List.of("game.rec", "game.notes")) {
            Files.copy(recorded.resolve(file), place.resolve(file));
        }
        RecordingRepository repository = new RecordingRepository(place, 1_000_000);
        studio = StudioServer.start(
                simulation.control(), 0, AccessToken.random(), new StudioFolders(place, Optional.of(repository)));
    }

    @BeforeAll
    static void record() throws IOException {
        RecordedRun.write(recorded.resolve("game.rec"));
        Files.writeString(recorded.resolve("game.notes"), """
                {"seconds":1,"robot":"Blue Newbies 1","level":"INFO","text":"I see the ball"}
                {"seconds":2,"robot":"Blue Newbies 1","level":"WARNING","text":"the joint is too fast"}
                {"drawn":"draw\\t1.0\\tAda\\t1\\tcircle\\tcyan\\t1.0\\t0.0\\t-0.5\\t0.4\\ttext\\tcyan\\t1.0\\t0.0\\t-0.5\\tball <here>"}
                """);
    }

    @AfterEach
    void close() {
        studio.close();
        simulation.close();
    }

    private void visit() {
        browser.visit(studio.oneTimeAddress() + "&quality=lowest&theme=light#replay/game");
        browser.await("studio.replay?.file?.isWhole && studio.cursor.recorded && !studio.replay.stale");
    }

    /** Clicks a button that starts a download, and reads the file. */
    private String given(String button, String name, String reading) {
        browser.evaluate("(() => { const make = URL.createObjectURL; window.givenName = '';"
                + " URL.createObjectURL = blob => { window.given = blob; return make(blob); };"
                + " HTMLAnchorElement.prototype.click = function () { window.givenName = this.download; }; })()");
        browser.click(button);
        browser.await("window.givenName === '" + name + "'");
        return browser.evaluate(reading).getAsString();
    }

    private double number(String expression) {
        return browser.evaluate(expression).getAsDouble();
    }

    @Tag("slow")
    @Test
    void linesOfLogsAreMarkedAndWarningsAreEvents() {
        visit();
        browser.await("document.querySelectorAll('.event.log').length === 1"
                + " && document.querySelector('.event.warning title')");

        assertThat(browser.evaluate("document.querySelector('.event.warning title').textContent")
                        .getAsString())
                .endsWith("Warning: Blue Newbies 1 says the joint is too fast");
        browser.evaluate("studio.replay.actions.find(action => action.shown === 'Home').act()");
        int warning = browser.evaluate("studio.replay.file.notes.find(note => note.kind === 'warning').index")
                .getAsInt();
        for (int presses = 0; presses < 12 && number(STATE + ".index") < warning; presses++) {
            browser.click("#event-next");
        }
        browser.await(STATE + ".index === " + warning);
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void recordedRunIsShownWithItsEvents() {
        visit();

        String kinds = browser.evaluate("studio.replay.file.run.events.map(event => event.kind).join(' ')")
                .getAsString();
        assertThat(kinds).contains("goal").contains("fall").contains("playmode");
        browser.press("End");
        browser.await("document.querySelector('.team.left').textContent === 'Ada'");
        browser.await("document.querySelectorAll('.event.goal').length === 1");
        assertThat(browser.complaints()).isEmpty();
    }

    @Tag("slow")
    @Test
    void draggingTheTimeLineMovesRobotsAndScore() {
        visit();
        String box = "document.querySelector('#replay-line').getBoundingClientRect()";
        double y = number(box + ".y + 28");
        double right = number(box + ".right - 14");

        browser.mouse("mousePressed", number(box + ".x + 60"), y);
        browser.await(STATE + ".index < 12 && studio.view.robots.poses.length === 1");
        browser.await("document.querySelector('.score').textContent.replace(/\\s/g, '') === '0:0'");
        double before = number("studio.view.robots.poses[0][2]");
        browser.mouse("mouseMoved", right, y);
        browser.mouse("mouseReleased", right, y);

        browser.await(STATE + ".index > " + STATE + ".count - 5");
        browser.await("studio.view.robots.poses[0][2] < " + (before - 0.1));
        browser.await("document.querySelector('.score').textContent.includes('1')");
    }

    @Tag("slow")
    @Test
    void eventsAreJumpedToAndTheRunIsPlayed() {
        visit();
        browser.click("#event-next");
        browser.await("document.querySelector('#toast').textContent.includes('Play mode')"
                + " || document.querySelector('#toast').textContent.includes('Goal')");
        browser.press("Home");
        browser.await(STATE + ".index === 0");
        browser.press("ArrowRight");
        browser.await(STATE + ".index === 1");

        browser.fill("#replay-speed", "8");
        browser.click("#replay-play");

        browser.await(STATE + ".index === " + STATE + ".count - 1 && !" + STATE + ".playing");
    }

    @Tag("slow")
    @Test
    void fieldShowsTheSameMomentUntilOneGoesBackToNow() {
        visit();

        browser.evaluate("location.hash = '#field'");
        browser.await("document.querySelector('.moment-reading').textContent.startsWith('Recording game at')");
        browser.await("!studio.view.stage.hidden && studio.cursor.shown(studio.state).tense === 'recorded'");
        browser.click("#go-live");

        browser.await("document.querySelector('.moment-reading').textContent === 'now'");
        browser.await("document.querySelector('.team.left').textContent === 'Blue_Newbies'");
        browser.await("getComputedStyle(document.querySelector('#transport')).display !== 'none'");
    }

    @Tag("slow")
    @Test
    void tableHasOneLineForEachCycle() {
        visit();

        String table = given("#export-csv", "game.csv", "window.given.text()");

        assertThat(table.lines().count()).isBetween(150L, 250L);
        assertThat(table)
                .startsWith("cycle,game_time_s,play_mode,score_left,score_right,ball_x_m,ball_y_m,ball_z_m,Ada_1_x_m,")
                .contains("\n100,");
        browser.evaluate("studio.replay.state = {...studio.replay.state, loop: [100, 149]}");
        assertThat(given("#export-csv", "game.csv", "window.given.text()").lines())
                .as("a head and the fifty cycles of the loop")
                .hasSize(51);
    }

    @Tag("slow")
    @Test
    void runIsGivenAsTheLogOfASimSparkServer() {
        visit();
        String log = given(
                "#export-log",
                "game.log.gz",
                "new Response(window.given.stream().pipeThrough(new DecompressionStream('gzip'))).text()");

        assertThat(log).contains("(RSG 0 1)").contains("(RDS 0 1)").contains("FieldLength");
    }

    @Tag("slow")
    @Test
    void secondRunIsComparedWithGhosts() throws IOException {
        Files.copy(place.resolve("game.rec"), place.resolve("other.rec"));
        visit();
        browser.await("document.querySelector('#compare-with').options.length === 2");

        browser.fill("#compare-with", "other");

        browser.await("document.querySelector('#compare-reading').textContent.includes('0.00 m')");
        browser.await("studio.view.robots.poses.length === 2");
        browser.await("document.querySelector('.compare-curve polyline').getAttribute('points')?.length > 20");
        assertThat(browser.complaints()).isEmpty();
    }

    @Tag("slow")
    @Test
    void singleFilePlaysWithoutTheStudio() throws IOException {
        browser.drawSharply();
        visit();
        String page = given("#export-html", "game.html", "window.given.text()");
        Path file = Files.writeString(place.resolve("game.html"), page);

        assertThat(Files.size(file)).isLessThan(1_500_000);
        browser.visit(file.toUri().toString());
        browser.await("player.replay.index > 5 && player.view.drawCalls > 0");
        browser.await("document.querySelector('.team.left').textContent === 'Ada'");
        assertThat(number("player.view.renderer.domElement.clientWidth")).isEqualTo(1366);
        assertThat(number("player.view.renderer.domElement.clientHeight")).isEqualTo(768);
        assertThat(number("document.querySelector('#replay').getBoundingClientRect().top"))
                .isBetween(500.0, 740.0);
        assertThat(number("document.querySelector('#replay').getBoundingClientRect().bottom"))
                .isLessThanOrEqualTo(768);
        assertThat(grassIn(browser.screenshot())).isGreaterThan(0.15);
        String line = "document.querySelector('.replay-line').getBoundingClientRect()";
        double x = number(line + ".x + 14 + 75 / (player.replay.count - 1) * (" + line + ".width - 28)");
        browser.mouse("mousePressed", x, number(line + ".y + 28"));
        browser.mouse("mouseReleased", x, number(line + ".y + 28"));
        browser.await("player.view.drawings.texts.children[0]?.name === 'ball <here>'"
                + " && !document.querySelector('#drawings').hidden");
        assertThat(browser.complaints()).allMatch(text -> text.contains("file:"));
    }

    /** The fraction of green pixels in a screenshot. */
    private static double grassIn(byte[] png) throws IOException {
        BufferedImage picture = ImageIO.read(new ByteArrayInputStream(png));
        int[] pixels = picture.getRGB(0, 0, picture.getWidth(), picture.getHeight(), null, 0, picture.getWidth());
        return Arrays.stream(pixels)
                .mapToObj(Color::new)
                .mapToInt(colour -> isGreen(colour) ? 1 : 0)
                .average()
                .orElseThrow();
    }

    private static boolean isGreen(Color colour) {
        return colour.getGreen() > Math.max(colour.getRed(), colour.getBlue()) + 25;
    }

    @Tag("slow")
    @Test
    void drawingsOfARobotStayOnTheGroundForASecond() {
        visit();
        browser.evaluate("studio.replay.actions.find(action => action.shown === 'Home').act()");
        browser.await(STATE + ".index === 0 && !studio.view.drawings.group.visible");

        browser.evaluate("studio.replay.actions.find(action => action.shown === 'Page down').act()");

        browser.await("studio.view.drawings.texts.children[0]?.name === 'ball <here>'");
        browser.await("studio.view.drawings.shapes.geometry.getAttribute('position').count === 48 * 6");
        browser.press("d");
        browser.await("!studio.view.drawings.group.visible");
        browser.press("d");
        browser.await("studio.view.drawings.group.visible");
        browser.evaluate("studio.replay.actions.find(action => action.shown === 'Page down').act()");
        browser.await("!studio.view.drawings.group.visible");
    }

    @Tag("slow")
    @Test
    void openingTheReplayKeepsTheLiveViewUntilARecordingIsChosen() {
        browser.visit(studio.oneTimeAddress() + "&quality=lowest&theme=light#replay");
        browser.await("document.querySelector('#recordings [data-recording=game]')");

        browser.evaluate("location.hash = '#field'");

        browser.await("studio.room() === 'field' && document.querySelector('.moment-reading').textContent === 'now'");
        browser.await("document.querySelector('.team.left').textContent === 'Blue_Newbies'");
        assertThat(browser.evaluate("studio.replay.file === undefined && studio.cursor.recorded === undefined")
                        .getAsBoolean())
                .isTrue();
    }

    @Tag("slow")
    @Test
    void recordingsAreCardsThatAreSearchedAndChosen() throws IOException {
        Files.copy(place.resolve("game.rec"), place.resolve("other.rec"));
        browser.visit(studio.oneTimeAddress() + "&quality=lowest&theme=light#replay");
        String card = "document.querySelector('#recordings [data-recording=game]')";
        browser.await(card + "?.innerText.includes('Ada')");
        assertThat(browser.evaluate(card + ".innerText").getAsString())
                .contains("00:04", "1 robot", "1 goal", "1 fall", "game");
        assertThat(number(card + ".querySelectorAll('circle.left, circle.ball').length"))
                .isEqualTo(2);
        assertThat(number(card + ".querySelector('.way.ball').points.length")).isGreaterThan(50);

        browser.fill("#recording-search", "oth");
        browser.evaluate("document.querySelector('#recording-search').dispatchEvent(new Event('input'))");
        browser.await(card + ".hidden && !document.querySelector('#recordings [data-recording=other]').hidden");
        browser.click("#recordings [data-recording=other] .open");

        browser.await("studio.replay.file?.isWhole && document.querySelector('#recordings').hidden");
        browser.await("document.querySelector('#recording-name').textContent === 'other'");
        assertThat(browser.complaints()).isEmpty();
    }

    @Tag("slow")
    @Test
    void barKeepsItsHeightWhileTwoRunsAreCompared() throws IOException {
        Files.copy(place.resolve("game.rec"), place.resolve("other.rec"));
        visit();
        browser.await("document.querySelector('#compare-with').options.length === 2");
        browser.fill("#compare-with", "other");
        browser.await("document.querySelector('#compare-reading').textContent.includes('0.00 m')");
        String height = "document.querySelector('#replay').offsetHeight";
        double before = number(height);

        browser.evaluate("document.querySelector('#compare-reading').textContent = 'Here: ball 10.00 m · 1 10.00 m"
                + " · 2 10.00 m · 3 10.00 m · 4 10.00 m'");

        assertThat(number(height)).isEqualTo(before);
        browser.await("document.querySelector('.compare-line').innerText.includes('Distance, 0 to 0.05 m')");
    }

    @Tag("slow")
    @Test
    void marksOfTheTimeLineHaveALegend() {
        visit();

        browser.await("document.querySelector('.replay-legend').innerText.includes('Fall')");
        assertThat(number("document.querySelectorAll('.replay-legend svg').length"))
                .isEqualTo(6);
    }

    @Tag("slow")
    @Test
    void replayWithoutRecordingsShowsAMessage() throws IOException {
        try (StudioServer empty = StudioServer.start(
                simulation.control(), 0, AccessToken.random(), new StudioFolders(place, Optional.empty()))) {
            browser.visit(empty.oneTimeAddress() + "&quality=lowest#replay");

            browser.await("document.querySelector('#replay').textContent.includes('Nothing has been recorded yet.')");
        }
    }

    @Tag("slow")
    @Tag("picture")
    @Test
    void takesScreenshotOfTheReplay() throws IOException {
        browser.drawSharply();
        try (WholeStudio whole = new WholeStudio(simulation.control(), place)) {
            browser.visit(whole.oneTimeAddress() + "&quality=high&theme=light#replay/game");
            browser.await("studio.replay?.file?.isWhole");
            browser.evaluate("studio.replay.actions.find(action => action.shown === 'End').act()");
            browser.await("studio.camera.isStill && " + STATE + ".index === " + STATE + ".count - 1"
                    + " && document.querySelector('#toast').hidden");
            Picture.ofDocumentation("docs/images/studio-replay.png", browser.screenshot());
        }

        assertThat(number("document.documentElement.scrollWidth")).isEqualTo(1366);
    }
}

package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.studio.search.SearchFeed;
import org.robonewbie.studio.search.SearchNumber;
import org.robonewbie.studio.search.SearchRound;
import org.robonewbie.studio.search.SearchTask;

/** The page of an optimisation in a real browser. */
@Tag("slow")
@InBrowser
class SearchPageTest {

    private static final int ROUNDS = 30;

    @TempDir
    private Path folder;

    private final Chromium browser;
    private final TestSimulator simulation = new TestSimulator();
    private final SearchFeed board = new SearchFeed(new SearchTask(
            "kick-right", "kick-distance", "m", true, ROUNDS, "30 rounds of 12 candidates with 4 trials each"));
    private StudioServer studio;

    SearchPageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void open() throws IOException {
        Files.writeString(folder.resolve("kick-so-far.txt"), "200" + " 0".repeat(22) + "\n");
        StudioFolders folders = new StudioFolders(folder, Optional.empty());
        studio = StudioServer.start(simulation.control(), 0, AccessToken.random(), folders, Optional.of(board));
        board.begins(5.612);
    }

    @AfterEach
    void close() {
        studio.close();
        simulation.close();
    }

    @Test
    void progressIsDrawnWhileItIsMade() {
        visit("");
        browser.await("document.querySelector('#outcome').textContent.includes('first candidates')");

        reach(1, 4);

        browser.await("document.querySelector('#facts').textContent.includes('4 of 30')");
        browser.await("search.valuePlot.data[0].length === 4 && search.stepPlot.data[1].length === 4");
        browser.await("document.querySelectorAll('.plot canvas').length === 2");
        browser.await("document.querySelectorAll('.number').length === 12");
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void axisOfRoundsHasWholeNumbers() {
        visit("");

        reach(1, 2);

        browser.await("search.valuePlot.data[0].length === 2 && search.valuePlot.axes[0]._splits.length > 1");
        assertThat(browser.evaluate("search.valuePlot.axes[0]._splits.every(Number.isInteger)")
                        .getAsBoolean())
                .isTrue();
    }

    @Test
    void pageThatComesLateSeesTheWholeHistory() {
        reach(1, 12);

        visit("");

        browser.await("search.valuePlot.data[1].length === 12");
        browser.await("document.querySelector('#facts').textContent.includes('5.612 m')");
    }

    @Test
    void motionAsItIsNowOpensInTheEditor() {
        reach(1, 2);
        visit("");
        browser.await("document.querySelector('#look').hidden === false");

        browser.visit(studio.address()
                .resolve(browser.evaluate("document.querySelector('#look').getAttribute('href')")
                        .getAsString())
                .toString());

        browser.await("studio.motion?.editor.state.name === 'kick-so-far'");
    }

    @Test
    void resultRemainsOnThePageWhenTheProgramEnds() {
        visit("");
        reach(1, ROUNDS);
        board.ends(6.087, "It is better. Written to kick.txt.", "#motion/kick");
        browser.await("document.querySelector('#outcome').textContent.includes('Written to kick.txt')");

        studio.close();

        browser.await("document.querySelector('#look').hidden");
        browser.await("document.querySelector('#outcome').textContent.includes('Written to kick.txt')"
                + " && document.querySelector('#facts').textContent.includes('6.087 m')"
                + " && search.valuePlot.data[1].length === 30");
    }

    @Test
    @Timeout(120)
    void programWaitsForOpenPages() throws Exception {
        visit("");
        browser.await("search.state.task !== undefined");
        assertThat(board.isWatched()).isTrue();

        browser.visit("about:blank");

        board.awaitUnwatched(() -> false);
        assertThat(board.isWatched()).isFalse();
    }

    @Test
    void unknownBrowsersSeeNothing() {
        browser.visit("http://localhost:" + studio.address().getPort() + "/optimise.html");

        browser.await("document.querySelector('#outcome').textContent.includes('This browser is not signed in')");
        assertThat(browser.evaluate("search.state.rounds.length").getAsInt()).isZero();
        browser.forgetComplaints();
    }

    @Tag("picture")
    @Test
    void takesScreenshotOfThePage() throws IOException {
        browser.drawSharply();
        reach(1, 22);
        for (String theme : List.of("dark", "light")) {
            visit("&theme=" + theme);
            browser.await("search.valuePlot.data[1].length === 22");
            browser.await("document.querySelectorAll('.number').length === 12");
            assertThat(browser.evaluate("document.documentElement.scrollWidth").getAsInt())
                    .isEqualTo(1366);
            Picture.keep("studio-optimise-" + theme + ".png", browser.screenshot());
        }
        Picture.ofDocumentation("docs/images/studio-optimise.png", browser.screenshot());
        assertThat(browser.complaints()).isEmpty();
    }

    private void visit(String options) {
        browser.visit(board.page(studio.oneTimeAddress()) + options);
    }

    /** An optimisation that improves and converges. */
    private void reach(int from, int to) {
        for (int i = from; i <= to; i++) {
            double settled = 1 - Math.exp(-i / 8.0);
            double best = 5.6 + 0.5 * settled + 0.03 * Math.sin(3 * i);
            double mean = 5.2 + 0.8 * settled + 0.05 * Math.cos(2 * i);
            double step = 0.15 * (1 + 0.2 * Math.sin(i / 3.0)) * Math.exp(-i / 25.0);
            SearchRound round = new SearchRound(i, best, mean, 0.8 + 0.2 * settled, step, 11.4, 4.2 * (ROUNDS - i));
            board.reached(round, numbers(settled, step), "#motion/kick-so-far");
        }
    }

    private static List<SearchNumber> numbers(double settled, double step) {
        List<String> joints = List.of("right hip pitch", "right knee pitch", "right foot pitch", "left hip roll");
        return List.of(1, 2, 3).stream()
                .flatMap(keyframe -> joints.stream()
                        .map(joint -> number(
                                keyframe, joint, settled * Math.sin(2.3 * keyframe + joints.indexOf(joint)), step)))
                .toList();
    }

    private static SearchNumber number(int keyframe, String joint, double change, double step) {
        double start = 12.5 * keyframe - 30;
        return new SearchNumber(
                "keyframe " + keyframe + ", " + joint, "degrees", start, start + 4 * change, 5 * step, 5);
    }
}

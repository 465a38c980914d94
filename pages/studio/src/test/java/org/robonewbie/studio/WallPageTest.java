package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.studio.wall.TrialWall;
import org.robonewbie.studio.wall.WallTable;

/** The wall of a contest in a real browser. */
@Tag("slow")
@InBrowser
class WallPageTest {

    private static final URI ALONE = URI.create("http://127.0.0.1:3999/");

    @TempDir
    private Path folder;

    private final Chromium browser;
    private final TestSimulator pitch = new TestSimulator();
    private final TestSimulator red = new TestSimulator().withRobot();
    private final TestSimulator blue = new TestSimulator().withRobot();
    private final TrialWall wall = new TrialWall("Scoring", "The earliest goal wins.");
    private StudioServer studio;

    WallPageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void open() throws IOException {
        StudioFolders folders = new StudioFolders(folder, Optional.empty());
        studio = StudioServer.start(pitch.control(), 0, AccessToken.random(), folders, Optional.of(wall));
        wall.stands(table(0, "not yet"));
        wall.begins("scoring-Red", List.of("Red"), red.control(), ALONE);
        wall.begins("scoring-Blue", List.of("Blue"), blue.control(), ALONE);
    }

    @AfterEach
    void close() {
        wall.close();
        studio.close();
        pitch.close();
        red.close();
        blue.close();
    }

    @Test
    void runningTrialsMoveSideBySide() {
        visit("");
        awaitBall("scoring-Red", 0);
        awaitBall("scoring-Blue", 0);

        moveBall(red, 3);
        moveBall(blue, -2);

        awaitBall("scoring-Red", 3);
        awaitBall("scoring-Blue", -2);
        assertThat(browser.evaluate("document.querySelectorAll('.tile .robot').length")
                        .getAsInt())
                .isEqualTo(2);
        assertThat(browser.evaluate("document.querySelector('.tile').getAttribute('href')")
                        .getAsString())
                .isEqualTo(ALONE.toString());
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void tableGrowsWithEachTrialThatIsOver() {
        visit("");
        browser.await("document.querySelector('#table').innerText.includes('not yet')");
        awaitBall("scoring-Red", 0);

        wall.ends("scoring-Red");
        wall.result("scoring-Red", "Red goal 12.3");
        wall.stands(table(1, "12.30 s"));

        browser.await("document.querySelector('#table').innerText.includes('12.30 s')");
        browser.await("document.querySelector('#progress-count').textContent === 'after 1 of 2 trials'");
        browser.await("document.querySelector('#results a').getAttribute('href').endsWith('#replay/scoring-Red')");
        browser.await("document.querySelector('[data-trial=scoring-Red]').dataset.running === 'false'");
        assertThat(browser.evaluate("document.querySelectorAll('.tile').length").getAsInt())
                .isEqualTo(2);
    }

    @Test
    void tableRemainsOnThePageWhenTheProgramEnds() {
        visit("");
        wall.isOver("Table: table.html");
        browser.await("document.querySelector('#wall-state').textContent.includes('Table: table.html')");

        studio.close();

        browser.await("wall.state.tiles.every(tile => !tile.running)");
        assertThat(browser.evaluate("document.querySelector('#wall-state').textContent")
                        .getAsString())
                .isEqualTo("The competition is over. Table: table.html");
    }

    @Test
    void unknownBrowsersSeeNothing() {
        browser.visit("http://localhost:" + studio.address().getPort() + "/wall.html");

        browser.await("document.querySelector('#wall-state').textContent.includes('This browser is not signed in')");
        assertThat(browser.evaluate("wall.state.tiles.length").getAsInt()).isZero();
        browser.forgetComplaints();
    }

    @ParameterizedTest
    @ValueSource(strings = {"light", "dark"})
    void wallHasNoViolation(String theme) {
        wall.ends("scoring-Red");
        wall.result("scoring-Red", "Red goal 12.3");
        visit("&theme=" + theme);
        awaitBall("scoring-Blue", 0);

        assertThat(new Axe().violations(browser)).isEmpty();
    }

    @Test
    void takesScreenshotOfThePage() throws IOException {
        browser.drawSharply();
        wall.result("scoring-Green", "Green goal 8.46");
        wall.stands(table(1, "8.46 s"));
        for (String theme : List.of("light", "dark")) {
            visit("&theme=" + theme);
            awaitBall("scoring-Blue", 0);
            assertThat(browser.evaluate("document.documentElement.scrollWidth").getAsInt())
                    .isEqualTo(1366);
            Picture.keep("studio-wall-" + theme + ".png", browser.screenshot());
        }
    }

    private void visit(String options) {
        browser.visit(wall.page(studio.oneTimeAddress()) + options);
    }

    private void awaitBall(String trial, double x) {
        browser.await("Math.abs((document.querySelector('[data-trial=" + trial
                + "] circle.ball')?.getAttribute('cx') ?? 99) - " + x + ") < 0.05");
    }

    private static void moveBall(TestSimulator trial, double x) {
        trial.order(new Order.MoveBall(Optional.of(new Vector3(x, 1, 0.04)), Optional.of(Vector3.ZERO)));
    }

    private static WallTable table(int over, String cell) {
        return new WallTable(
                over,
                2,
                List.of("Goal after", "Trial"),
                List.of(
                        new WallTable.Place(1, "Red", List.of(cell, "played to the end")),
                        new WallTable.Place(2, "Blue", List.of("–", "not yet"))));
    }
}

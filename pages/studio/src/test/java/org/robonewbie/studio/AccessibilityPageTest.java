package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.studio.search.SearchFeed;
import org.robonewbie.studio.search.SearchTask;

/** axe-core finds no violation in any room or dialog, in the light and the dark theme. */
@Tag("slow")
@InBrowser
class AccessibilityPageTest {

    private static final String FIELD_IS_THERE = "studio.view.drawCalls > 0";
    private static final String PROGRAM_IS_THERE = "studio.rooms.program?.files?.file !== undefined";
    private static final String ROBOT_IS_THERE = "document.querySelectorAll('.joint-row').length === 22";
    private static final String MOTION_IS_THERE = "studio.motion?.editor.state.name === 'mine' && !studio.motion.stale";
    private static final String RECORDING_IS_THERE =
            "studio.replay?.file?.isWhole && studio.cursor.recorded && !studio.replay.stale";

    private final Chromium browser;
    private final Axe axe = new Axe();

    @TempDir
    private Path folder;

    private FurnishedStudio studio;

    AccessibilityPageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void open() throws IOException {
        studio = new FurnishedStudio(folder);
    }

    @AfterEach
    void close() {
        studio.close();
    }

    @ParameterizedTest
    @ValueSource(strings = {"light", "dark"})
    void roomsHaveNoViolation(String theme) {
        visit(theme, "#field", FIELD_IS_THERE);
        assertClean("Field");
        visit(theme, "#field/exercises", "document.querySelector('[data-exercise=kick]')");
        assertClean("Exercises");
        visit(theme, "#program", PROGRAM_IS_THERE);
        assertClean("Program");
        visit(theme, "#robot", ROBOT_IS_THERE);
        assertClean("Robot");
        visit(theme, "#motion/mine", MOTION_IS_THERE);
        assertClean("Motion");
        visit(theme, "#replay", "document.querySelector('[data-recording=game]')");
        assertClean("Recordings");
        visit(theme, "#replay/game", RECORDING_IS_THERE);
        assertClean("Replay");
    }

    @ParameterizedTest
    @ValueSource(strings = {"light", "dark"})
    void searchHasNoViolation(String theme) throws IOException {
        SearchFeed board = new SearchFeed(new SearchTask("kick", "kick-distance", "m", true, 3, "3 rounds"));
        StudioFolders folders = new StudioFolders(folder, Optional.empty());
        try (StudioServer other = StudioServer.start(
                studio.simulation().control(), 0, AccessToken.random(), folders, Optional.of(board))) {
            browser.visit(board.page(other.oneTimeAddress()) + "&theme=" + theme);
            browser.await("search.state.task !== undefined");

            assertClean("Search");
        }
    }

    @Tag("slow")
    @ParameterizedTest
    @ValueSource(strings = {"light", "dark"})
    void dialogsOfARoomHaveNoViolation(String theme) {
        visit(theme, "#field", FIELD_IS_THERE);
        openAll();
        assertClean("Field with all that folds");
        browser.click("#help-button");
        browser.await("document.querySelector('#help').open");
        assertClean("Keys");
        visit(theme, "#field/exercises", "document.querySelector('[data-exercise=kick]')");
        browser.click("[data-exercise=kick]");
        browser.await("document.querySelector('#course-program').options.length === 2");
        openAll();
        assertClean("an exercise");
        visit(theme, "#robot", ROBOT_IS_THERE);
        browser.click("#message-tab");
        openAll();
        assertClean("Robot with all that folds");
    }

    @Tag("slow")
    @ParameterizedTest
    @ValueSource(strings = {"light", "dark"})
    void mistakeInAProgramHasNoViolation(String theme) {
        visit(theme, "#program", PROGRAM_IS_THERE);
        browser.evaluate("studio.rooms.program.editor.replace('int angle = " + SmallWorkshop.MISTAKE + ";')");
        browser.await("document.querySelector('#program-state').innerText.includes('1 error')");
        assertClean("a mistake");
        browser.fill("#program-file", "exercise kick");
        browser.await("document.querySelector('#program-check') && !document.querySelector('#program-remarks li')");
        assertClean("an exercise in the room for programs");
    }

    @Tag("slow")
    @ParameterizedTest
    @ValueSource(strings = {"light", "dark"})
    void historyOfAProgramHasNoViolation(String theme) {
        visit(theme, "#program", PROGRAM_IS_THERE);
        browser.click("#program-save");
        browser.await("document.querySelector('#program-save').disabled");
        browser.evaluate("studio.rooms.program.editor.replace('int angle = 3;')");
        browser.click("#program-history");
        browser.await("document.querySelector('#versions')");
        assertClean("History");
    }

    @Tag("slow")
    @ParameterizedTest
    @ValueSource(strings = {"light", "dark"})
    void dialogsOfAnEditorHaveNoViolation(String theme) {
        visit(theme, "#motion/mine", MOTION_IS_THERE);
        browser.click("#timeline-curves");
        browser.click("#motion-tools .menu-head");
        assertClean("curves");
        browser.click("#save-as");
        browser.await("document.querySelector('#answer')");
        assertClean("Save as");
    }

    @Tag("slow")
    @ParameterizedTest
    @ValueSource(strings = {"light", "dark"})
    void dialogsOfARecordingHaveNoViolation(String theme) throws IOException {
        Files.copy(folder.resolve("game.rec"), folder.resolve("other.rec"));
        visit(theme, "#replay/game", RECORDING_IS_THERE);
        openAll();
        browser.evaluate("document.querySelector('#bookmark-note').value = 'here'");
        browser.click("#bookmark-add");
        browser.await("document.querySelector('.bookmark-go')");
        assertClean("bookmarks");
        browser.fill("#compare-with", "other");
        browser.await("document.querySelector('#compare-reading').textContent !== ''");
        assertClean("comparison");
        visit(theme, "#replay", "document.querySelector('[data-recording=game]')");
        browser.clickElement("document.querySelectorAll('.recording-tools button')[1]");
        assertClean("another name");
        browser.clickElement("document.querySelectorAll('.recording-tools button')[2]");
        browser.await("document.querySelector('#recording-undo').checkVisibility()");
        assertClean("deleted recording");
    }

    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"1024, 768", "820, 1180", "390, 844"})
    void smallScreensHaveNoViolation(int width, int height) {
        browser.resize(width, height);

        roomsHaveNoViolation("light");
    }

    private void openAll() {
        browser.evaluate("document.querySelectorAll('details').forEach(each => each.open = true)");
    }

    private void visit(String theme, String room, String isThere) {
        browser.visit(studio.oneTimeAddress() + "&quality=lowest&theme=" + theme + room);
        browser.await("studio.state.scene.robots.length === 1");
        browser.await(isThere);
    }

    /** Checks after the page has updated hidden elements, which it does twice a second. */
    private void assertClean(String place) {
        browser.evaluate("window.studio?.workspace.markMore()");
        assertThat(axe.violations(browser)).as(place).isEmpty();
    }
}

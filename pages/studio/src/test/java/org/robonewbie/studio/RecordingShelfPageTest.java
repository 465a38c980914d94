package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.simulator.file.RecordingAbout;
import org.robonewbie.simulator.file.RecordingRepository;

/** Management of recordings in a real browser. */
@Tag("slow")
@InBrowser
class RecordingShelfPageTest {

    private static final String GAME = "#recordings [data-recording=game]";

    @TempDir
    private static Path recorded;

    private final Chromium browser;
    private final TestSimulator simulation = new TestSimulator().withRobot();

    @TempDir
    private Path place;

    private StudioServer studio;

    RecordingShelfPageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeAll
    static void record() throws IOException {
        RecordedRun.write(recorded.resolve("game.rec"));
    }

    @BeforeEach
    void open() throws IOException {
        Path project = Files.createDirectory(place.resolve("project"));
        Path runs = Files.createDirectory(place.resolve("runs"));
        Files.copy(recorded.resolve("game.rec"), runs.resolve("game.rec"));
        Files.writeString(
                runs.resolve("game.notes"), "{\"seconds\":1,\"robot\":\"A 1\",\"level\":\"INFO\",\"text\":\"hm\"}\n");
        Files.copy(recorded.resolve("game.rec"), project.resolve("mine.rec"));
        new RecordingAbout("Agent_Wave", "elsewhere", false, List.of()).write(runs.resolve("game.rec"));
        StudioFolders folders = new StudioFolders(
                place.resolve("motions"),
                place.resolve("scenes"),
                Optional.of(new RecordingRepository(runs, 1_000_000)),
                List.of(project),
                Optional.empty());
        studio = StudioServer.start(simulation.control(), 0, AccessToken.random(), folders);
        browser.visit(studio.oneTimeAddress() + "&quality=lowest&theme=light#replay");
        browser.await("document.querySelector('" + GAME + " .way.ball')");
    }

    @AfterEach
    void close() {
        studio.close();
        simulation.close();
    }

    private boolean holds(String condition) {
        return browser.evaluate(condition).getAsBoolean();
    }

    private RecordingAbout about(String file) {
        return RecordingAbout.of(place.resolve("runs").resolve(file));
    }

    @Test
    void cardShowsTheAgentAndTheFilterSelectsTheProject() {
        browser.await("document.querySelector('" + GAME + "').innerText.includes('Agent_Wave')");

        browser.fill("#recording-filter", "project");

        browser.await("document.querySelector('" + GAME + "').hidden");
        assertThat(holds("document.querySelector('#recordings [data-recording=mine]').hidden"))
                .isFalse();
    }

    @Test
    void starIsKeptBesideTheRecordingAndCanBeFiltered() {
        browser.click(GAME + " .star");
        browser.await("document.querySelector('" + GAME + " .star').ariaPressed === 'true'");

        browser.fill("#recording-filter", "starred");

        browser.await("document.querySelector('#recordings [data-recording=mine]').hidden");
        assertThat(about("game.rec").starred()).isTrue();
        assertThat(about("game.rec").agent()).isEqualTo("Agent_Wave");
    }

    @Test
    void recordingIsRenamedWithAllThatLiesBesideIt() {
        browser.clickElement(
                "[...document.querySelectorAll('" + GAME + " button')].find(each => each.textContent === 'Rename')");
        browser.evaluate("document.querySelector('" + GAME + " input').value = 'our first goal'");
        browser.press("Enter");
        browser.await("document.querySelector('[data-recording=\"our first goal\"] .way.ball')");
        assertThat(place.resolve("runs").resolve("our first goal.rec")).exists();
        assertThat(place.resolve("runs").resolve("our first goal.notes")).exists();
        assertThat(about("our first goal.rec").agent()).isEqualTo("Agent_Wave");
        assertThat(place.resolve("runs").resolve("game.rec")).doesNotExist();
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void deletedRecordingIsRestoredByUndo() throws IOException {
        byte[] before = Files.readAllBytes(place.resolve("runs").resolve("game.rec"));
        browser.clickElement(
                "[...document.querySelectorAll('" + GAME + " button')].find(each => each.textContent === 'Delete')");
        browser.await("!document.querySelector('" + GAME + "') && !document.querySelector('#recording-undo').hidden");
        assertThat(place.resolve("runs").resolve("game.rec")).doesNotExist();

        browser.click("#recording-undo");

        browser.await("document.querySelector('" + GAME + " .way.ball')");
        assertThat(place.resolve("runs").resolve("game.rec")).hasBinaryContent(before);
        assertThat(place.resolve("runs").resolve("game.notes")).exists();
        assertThat(about("game.rec").agent()).isEqualTo("Agent_Wave");
    }

    @Test
    void bookmarkIsKeptAndItsAddressShowsTheMoment() {
        browser.click(GAME + " .open");
        browser.await("studio.replay.file?.isWhole && studio.cursor.recorded");
        browser.evaluate("studio.replay.actions.find(action => action.shown === 'Page down').act()");
        browser.press("m");
        browser.fill("#bookmark-note", "here it stumbles");
        browser.click("#bookmark-add");
        browser.await("document.querySelector('.bookmark-go')?.textContent === '1.00 s here it stumbles'");
        assertThat(about("game.rec").bookmarks()).containsExactly(new RecordingAbout.Bookmark(1, "here it stumbles"));

        browser.evaluate("studio.replay.actions.find(action => action.shown === 'End').act()");
        browser.click(".bookmark-go");
        browser.await("studio.replay.state.index === 50");
        browser.clickElement(
                "[...document.querySelectorAll('.bookmark-list button')].find(b => b.textContent === 'Delete')");
        browser.await("!document.querySelector('.bookmark-go')");
        browser.clickElement(
                "[...document.querySelectorAll('.bookmark-form button')].find(b => b.textContent === 'Undo')");
        browser.await("document.querySelector('.bookmark-go')");

        browser.visit("about:blank");
        browser.visit(studio.oneTimeAddress() + "&quality=lowest#replay/game@1.5");
        browser.await("studio.replay?.state.index === 75 && studio.cursor.recorded?.frame.cycle > 70");
        browser.evaluate("location.hash = '#replay/game@2'");
        browser.await("studio.replay.state.index === 100");
        browser.evaluate("location.hash = '#replay/game@play'");
        browser.await("studio.replay.state.playing && studio.replay.state.index < 100");
        assertThat(browser.complaints()).isEmpty();
    }
}

package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.simulator.file.RecordingFile;
import org.robonewbie.simulator.monitor.RecordedLog;
import org.robonewbie.simulator.recording.RecordingReader;

/** Recordings of the static page in its replay. */
@InBrowser
@Timeout(300)
class ReplayInThePageTest {

    private static final String COUNT = "studio.replay.state.count";
    private static final String LIST =
            "fetch('api/recordings').then((answer) => answer.json()).then(({ recordings }) => recordings)";

    @TempDir
    private Path folder;

    private final Chromium browser;
    private StaticServer server;

    ReplayInThePageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void open() throws IOException {
        server = new StaticServer(Path.of("target", "web").toAbsolutePath(), folder);
        visit("");
        browser.await("studio.state.frame?.cycle > 100");
    }

    private void visit(String search) {
        browser.visit(server.address() + search);
    }

    @AfterEach
    void end() {
        server.close();
    }

    private String name(int index) {
        return browser.evaluate(LIST + ".then((all) => all[" + index + "].name)")
                .getAsString();
    }

    private void show(String name) {
        browser.evaluate("location.hash = '#replay/' + encodeURIComponent(" + Chromium.quoted(name) + ")");
        browser.await(
                "studio.replay && studio.replay.file?.name === " + Chromium.quoted(name) + " && " + COUNT + " > 100");
    }

    @Test
    void runOfThePageIsShownFromItsBeginningAndGrows() {
        show(name(0));
        long before = browser.evaluate(COUNT).getAsLong();
        browser.await(COUNT + " > " + (before + 100));

        browser.evaluate("studio.replay.actions.find((action) => action.shown === 'Home').act()");
        browser.await("studio.replay.state.index === 0 && studio.cursor.recorded");

        assertThat(browser.evaluate("studio.cursor.recorded.frame.robots.length")
                        .getAsInt())
                .isEqualTo(1);
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void recordingAndBookmarkSurviveAReload() {
        String name = name(0);
        show(name);
        browser.evaluate("studio.replay.actions.find((action) => action.shown === 'Home').act()");
        browser.evaluate("studio.replay.actions.find((action) => action.shown === 'M').act()");
        browser.fill("#bookmark-note", "where it begins");
        browser.click("#bookmark-add");
        browser.await("document.querySelector('.bookmark-list').textContent.includes('0.00 s where it begins')");

        visit("?agent=Agent_Dance");
        browser.await("studio.state.frame?.cycle > 100");

        show(name);
        assertThat(browser.evaluate("studio.replay.file.run.summary.rosters.length")
                        .getAsInt())
                .isPositive();
        browser.await("document.querySelector('.bookmark-list').textContent.includes('0.00 s where it begins')");
        assertThat(browser.evaluate(LIST).getAsJsonArray())
                .extracting(each -> each.getAsJsonObject().get("agent").getAsString())
                .containsExactly("Agent_Dance", "Agent_BetterSoccer");
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void deletedRecordingIsRestored() {
        visit("?agent=Agent_Dance");
        browser.await("studio.state.frame?.cycle > 100");
        String old = name(1);
        show(name(0));
        browser.click("#recording");

        browser.click("[data-recording='" + old + "'] [title^='Delete']");
        browser.await("!document.querySelector(`[data-recording='" + old + "']`)");
        browser.click("#recording-undo");
        browser.await("document.querySelector(`[data-recording='" + old + "'] polyline`)");

        assertThat(name(1)).isEqualTo(old);
    }

    @Test
    void recordingIsDownloadedAndImported() throws IOException {
        show(name(0));
        Path file = browser.download(folder, () -> browser.click("#export-recording"));
        assertThat(cycles(file)).isGreaterThan(100);

        Path copy = Files.move(file, folder.resolve("game.rec"));
        browser.evaluate("fetch('game.rec').then((answer) => answer.blob()).then((blob) => {"
                + " const given = new DataTransfer(); given.items.add(new File([blob], 'game.rec'));"
                + " const choice = document.querySelector('#recording-file'); choice.files = given.files;"
                + " choice.dispatchEvent(new Event('change')); })");

        browser.await("studio.replay.file?.name === 'game' && " + COUNT + " > 100");
        assertThat(browser.evaluate(COUNT).getAsLong()).isEqualTo(cycles(copy));
    }

    private static long cycles(Path file) throws IOException {
        long count = 0;
        try (RecordingReader reader = RecordingFile.read(file)) {
            while (reader.next().isPresent()) {
                count++;
            }
        }
        return count;
    }

    @Test
    void fileThatIsNoRecordingIsRefused() {
        show(name(0));
        browser.evaluate(
                "(() => { const given = new DataTransfer(); given.items.add(new File(['Hello'], 'letter.rec'));"
                        + " const choice = document.querySelector('#recording-file'); choice.files = given.files;"
                        + " choice.dispatchEvent(new Event('change')); })()");

        browser.await(
                "document.querySelector('#toast').innerText.includes('“letter.rec” is not a RoboNewbie recording')");
    }

    @Test
    void logForOtherViewersIsThatOfTheCommandLine() throws IOException {
        show(name(0));
        visit("?agent=Agent_Dance");
        browser.await("studio.state.frame?.cycle > 100");
        show(name(1));

        Path recording = browser.download(folder, () -> browser.click("#export-recording"));
        Path packed = browser.download(folder, () -> browser.click("#export-log"));

        Path log = folder.resolve("here.log");
        RecordedLog.write(recording, log);
        try (GZIPInputStream there = new GZIPInputStream(Files.newInputStream(packed))) {
            assertThat(there.readAllBytes()).isEqualTo(Files.readAllBytes(log));
        }
    }

    @Test
    void linesOfTheLogStandOnTheTimeLine() {
        visit("?agent=Agent_BasicStructure");
        browser.await("studio.state.frame?.cycle > 100");
        show(name(0));

        browser.await("studio.replay.file.events.some(({ kind }) => kind === 'log')");
        JsonObject event = browser.evaluate("studio.replay.file.events.find(({ kind }) => kind === 'log')")
                .getAsJsonObject();
        assertThat(event.get("text").getAsString()).startsWith("RoboNewbie 1 says ");
    }
}

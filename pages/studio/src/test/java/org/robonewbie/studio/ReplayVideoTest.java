package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.simulator.file.RecordingRepository;

/** Videos of recordings, encoded and played by a real browser. */
@Tag("slow")
@InBrowser
class ReplayVideoTest {

    private static final String CATCH_FILES =
            "(() => { window.givenName = ''; URL.createObjectURL = blob => { window.given = blob; return 'blob:none'; };"
                    + " HTMLAnchorElement.prototype.click = function () { window.givenName = this.download; }; })()";

    private final Chromium browser;
    private final TestSimulator simulation = new TestSimulator().withRobot();

    @TempDir
    private Path place;

    private StudioServer studio;

    ReplayVideoTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void open() throws IOException {
        RecordedRun.write(place.resolve("game.rec"));
        StudioFolders folders = new StudioFolders(place, Optional.of(new RecordingRepository(place, 1_000_000)));
        studio = StudioServer.start(simulation.control(), 0, AccessToken.random(), folders);
        browser.drawSharply();
        browser.visit(studio.oneTimeAddress() + "&quality=lowest&theme=light#replay/game");
        browser.await("studio.replay?.file?.isWhole && studio.cursor.recorded");
        browser.evaluate(CATCH_FILES);
    }

    @AfterEach
    void close() {
        studio.close();
        simulation.close();
    }

    private double number(String expression) {
        return browser.evaluate(expression).getAsDouble();
    }

    @Test
    void videoOfASectionLastsAsLongAsTheSectionAndShowsTheField() throws IOException {
        browser.evaluate("studio.replay.state = {...studio.replay.state, loop: [50, 124]}");

        browser.click("#export-video");
        browser.await("window.givenName === 'game.webm'");

        String content = browser.evaluate(
                        "new Promise((done) => { const reader = new FileReader();"
                                + " reader.onload = () => done(reader.result.split(',')[1]); reader.readAsDataURL(window.given); })")
                .getAsString();
        Picture.keep("replay.webm", Base64.getDecoder().decode(content));
        Path page = Files.writeString(
                place.resolve("video.html"),
                "<!doctype html><video muted src=\"data:video/webm;base64," + content + "\"></video>");
        browser.visit(page.toUri().toString());
        browser.evaluate("window.film = document.querySelector('video')");
        browser.await("film.readyState >= 2");
        assertThat(number("film.duration")).isCloseTo(1.5, within(0.05));
        assertThat(number("film.videoWidth")).isEqualTo(1280);
        assertThat(number("film.videoHeight")).isEqualTo(720);
        for (double seconds : new double[] {0.02, 1.46}) {
            browser.evaluate("new Promise((done) => { film.onseeked = done; film.currentTime = " + seconds + "; })");
            assertThat(
                            number(
                                    "(() => { const canvas = document.createElement('canvas'); canvas.width = 320;"
                                            + " canvas.height = 180; const pen = canvas.getContext('2d'); pen.drawImage(film, 0, 0, 320, 180);"
                                            + " const {data} = pen.getImageData(0, 0, 320, 180); let green = 0;"
                                            + " for (let i = 0; i < data.length; i += 4)"
                                            + " { green += data[i + 1] > Math.max(data[i], data[i + 2]) + 25; } return green / (320 * 180); })()"))
                    .as("share of grass after " + seconds + " s")
                    .isGreaterThan(0.15);
        }
        browser.evaluate("film.play()");
        browser.await("film.ended");
    }

    @Test
    void videoThatIsCancelledGivesNoFile() {
        browser.evaluate("document.querySelector('#export-video').click()");
        browser.await("!document.querySelector('#export-progress').hidden"
                + " && document.querySelector('#export-progress progress').value > 0");

        browser.click("#export-progress button");

        browser.await("document.querySelector('#toast').textContent === 'The export was cancelled.'");
        assertThat(browser.evaluate("document.querySelector('#export-progress').hidden"
                                + " && !document.querySelector('.video-stage') && window.givenName === ''")
                        .getAsBoolean())
                .isTrue();
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void browserWithoutAnEncoderShowsAMessage() {
        browser.evaluate("delete window.VideoEncoder");

        browser.click("#export-video");

        browser.await("document.querySelector('#toast').textContent"
                + ".startsWith('The export failed: this browser cannot encode videos.')");
    }
}

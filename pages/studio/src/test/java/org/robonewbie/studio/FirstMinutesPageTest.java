package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.protocol.telemetry.TelemetryItem;
import org.robonewbie.protocol.telemetry.TelemetryMessage;

/** First visit of the studio: the three first steps, a gamepad, and a program with errors. */
@Tag("slow")
@InBrowser(width = 1366, height = 768)
class FirstMinutesPageTest {

    private static final String STEPS = "document.querySelector('#first-steps')";

    @TempDir
    private Path folder;

    private final Chromium browser;
    private SteeredField field;

    FirstMinutesPageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void open() throws IOException {
        field = new SteeredField(browser, folder);
    }

    @AfterEach
    void close() {
        field.close();
    }

    @Test
    void threeStepsAreCrossedOutWhenTheyAreDoneAndThenGoneForGood() {
        browser.await(STEPS + ".checkVisibility() && " + STEPS + ".querySelectorAll('li').length === 3");

        browser.evaluate("studio.send({do: 'placeBall', x: 1, y: 1, z: 0.042})");
        browser.await(STEPS + ".querySelectorAll('.done').length === 1");
        field.addPuppet();
        browser.press("w");
        browser.await(STEPS + ".querySelectorAll('.done').length === 2");
        browser.evaluate("location.hash = '#motion'");
        browser.await(STEPS + ".hidden");

        field.visit();
        browser.await(STEPS + ".hidden");
    }

    @Test
    void stepsAreDismissedPermanently() {
        browser.clickElement(STEPS + ".querySelector('button')");

        browser.await(STEPS + ".hidden");
        field.visit();
        browser.await(STEPS + ".hidden");
    }

    @Test
    void puppetIsSteeredWithAGamepad() {
        field.addPuppet();
        browser.evaluate("window.pad = {connected: true, axes: [0, 0, 0, 0],"
                + " buttons: Array.from({length: 16}, () => ({pressed: false}))};"
                + " navigator.getGamepads = () => [null, pad]");
        browser.await("!document.querySelector('#gamepad').hidden");
        double before =
                browser.evaluate("studio.state.frame.robots[0].torso[0]").getAsDouble();

        browser.evaluate("pad.axes[1] = -1");

        browser.await("studio.state.frame.robots[0].torso[0] > " + (before + 0.1));
        browser.evaluate("pad.axes[1] = 0");
        browser.await("studio.puppet.padWalk === JSON.stringify({forward: 0, left: 0, turn: 0})");
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void mistakeOfAProgramIsShownOnThePictureWhicheverRobotIsWatched() {
        TelemetryItem mistake = new TelemetryItem.LogEntry("WARNING", "Joint speed NaN for NECK_YAW. (Walk.java:31)");
        field.studio().telemetry().accept(new TelemetryMessage("Stars", 4, 1.5, mistake));
        field.studio().telemetry().accept(new TelemetryMessage("Stars", 4, 1.6, mistake));

        browser.await("document.querySelector('#diagnostics').checkVisibility()"
                + " && document.querySelector('#diagnostics li').textContent.includes('NECK_YAW')");

        assertThat(browser.evaluate("document.querySelectorAll('#diagnostics li').length")
                        .getAsInt())
                .isEqualTo(1);
        browser.click("#diagnostics > button");
        browser.await("document.querySelector('#diagnostics').hidden");
    }
}

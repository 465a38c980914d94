package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A newcomer opens the static page for the first time. */
@Tag("slow")
@InBrowser(newcomer = true)
@Timeout(300)
class FirstMinuteInThePageTest {

    private static final String CARD = "document.querySelector('#first-minute')";
    private static final String GHOST =
            "document.querySelector('#program-editor').shadowRoot.querySelector('.cm-ghost')";
    private static final int CTRL = 2;

    private final Chromium browser;
    private StaticServer server;

    FirstMinuteInThePageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void open() throws IOException {
        server = new StaticServer(Path.of("target", "web").toAbsolutePath());
        browser.visit(server.address());
    }

    @AfterEach
    void end() {
        server.close();
    }

    private void awaitCard(String text) {
        browser.await(CARD + "?.checkVisibility() && " + CARD + ".innerText.includes(" + Chromium.quoted(text) + ")");
    }

    private void passLevel(String title) {
        awaitCard(title);
        browser.await(GHOST + " !== null");
        while (!browser.evaluate(GHOST + " === null").getAsBoolean()) {
            browser.press("Tab");
        }
        awaitCard("Press ▶ Run");
        browser.press("Enter", CTRL);
        awaitCard("Well done: ");
        browser.press("Enter");
    }

    @Test
    void threeLevelsLeadToTheFirstExerciseAndStayPassed() {
        passLevel("Make the robot wave");
        passLevel("Make it look at the ball");
        passLevel("Make it walk to the ball and kick");

        browser.await("document.querySelector('#program-check') !== null");
        browser.await("studio.state.scene.robots.length === 0");
        assertThat(browser.evaluate(
                                "studio.rooms.program.service.read('own', 'Wave.java').then(({ text }) => text.content)")
                        .getAsString())
                .contains("LEFT_SHOULDER_PITCH, 90");
        assertThat(browser.complaints()).isEmpty();
        browser.visit(server.address());
        browser.await("studio.state.frame?.cycle > 50");
        assertThat(browser.evaluate("location.hash").getAsString()).isEmpty();
    }

    @Test
    void skippedLevelsNeverReturn() {
        awaitCard("Make the robot wave");

        browser.click("#first-minute-skip");

        browser.await("!" + CARD + ".checkVisibility()");
        browser.visit(server.address());
        browser.await("studio.state.frame?.cycle > 50");
        assertThat(browser.evaluate("location.hash").getAsString()).isEmpty();
    }
}

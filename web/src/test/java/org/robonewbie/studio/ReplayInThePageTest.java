package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The recording of the world that the static page shows, in its room Replay. */
@InBrowser
@Timeout(300)
class ReplayInThePageTest {

    private static final String COUNT = "studio.replay.state.count";

    private final Chromium browser;
    private StaticServer server;

    ReplayInThePageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void open() throws IOException {
        server = new StaticServer(Path.of("target", "web").toAbsolutePath());
        browser.visit(server.address());
        browser.await("studio.state.frame.cycle > 100");
    }

    @AfterEach
    void end() {
        server.close();
    }

    @Test
    void runOfThePageIsShownFromItsBeginningAndGrows() {
        browser.evaluate("location.hash = '#replay/world-1'");
        browser.await("studio.replay && " + COUNT + " > 100");
        long before = browser.evaluate(COUNT).getAsLong();
        browser.await(COUNT + " > " + (before + 100));

        browser.evaluate("studio.replay.deeds.find((deed) => deed.shown === 'Home').act()");
        browser.await("studio.replay.state.index === 0 && studio.cursor.recorded");

        assertThat(browser.evaluate("studio.cursor.recorded.frame.robots.length")
                        .getAsInt())
                .isEqualTo(1);
        assertThat(browser.complaints()).isEmpty();
    }
}

package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.simulator.embedded.RedirectPage;

/** Sign-in of a real Firefox by the page file that openers name; {@code SignInPageTest} is the counterpart for Chromium. */
@Timeout(300)
class SignInInFirefoxTest {

    private static final String IS_LIVE = "studio.state.connection === 'live'";

    @TempDir
    private Path folder;

    private final String usersHome = System.getProperty("user.home");

    @BeforeEach
    void moveHome() {
        System.setProperty("user.home", folder.toString());
    }

    @AfterEach
    void moveBack() {
        System.setProperty("user.home", usersHome);
    }

    @Test
    void pageFileLetsABrowserInAndTwoStudiosDoNotLogEachOtherOut() throws IOException {
        try (Firefox browser = Firefox.start(Files.createDirectory(folder.resolve("profile")));
                TestSimulator simulation = new TestSimulator().withRobot();
                StudioServer first = StudioServer.start(simulation.control(), 0, AccessToken.random());
                StudioServer second = StudioServer.start(simulation.control(), 0, AccessToken.random())) {
            for (StudioServer studio : new StudioServer[] {first, second}) {
                browser.visit(
                        RedirectPage.write(studio.oneTimeAddress()).toUri().toString());
                browser.await("typeof studio === 'object' && " + IS_LIVE);
                assertThat(browser.evaluate("location.href + document.cookie").getAsString())
                        .isEqualTo(studio.address().toString());
            }
            for (StudioServer studio : new StudioServer[] {first, second}) {
                browser.visit(studio.address().toString());
                browser.await(IS_LIVE);
            }
        }
    }

    @Test
    void usedAddressSaysHowToGetAnotherOne() throws IOException {
        try (Firefox browser = Firefox.start(Files.createDirectory(folder.resolve("profile")));
                TestSimulator simulation = new TestSimulator();
                StudioServer studio = StudioServer.start(simulation.control(), 0, AccessToken.random())) {
            String used = studio.oneTimeAddress().toString();
            StudioCookie.of(URI.create(used));

            browser.visit(used);

            browser.await("document.body.innerText.includes('Press Enter in the terminal')");
        }
    }
}

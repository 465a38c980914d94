package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.simulator.embedded.RedirectPage;

/** A browser signs in with an address that works once, and stays signed in. */
@InBrowser
class SignInPageTest {

    private static final String CHEAP = "&quality=lowest";

    private final Chromium browser;
    private final TestSimulator simulation = new TestSimulator();
    private StudioServer studio;

    SignInPageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void start() throws IOException {
        studio = StudioServer.start(simulation.control(), 0, AccessToken.random());
    }

    @AfterEach
    void close() {
        studio.close();
        simulation.close();
    }

    @Tag("slow")
    @Test
    void unknownBrowserShowsHowToSignInAndThenReconnects() {
        String elsewhere = "http://localhost:" + studio.address().getPort() + "/"; // without the cookie of 127.0.0.1
        browser.visit(elsewhere + "?quality=lowest");

        browser.await("document.querySelector('#banner').innerText.includes('Press Enter in the terminal')");
        browser.evaluate("fetch('" + elsewhere + "?" + studio.oneTimeAddress().getQuery() + "')");
        browser.await("studio.state.connection === 'live'");
        browser.forgetComplaints();
    }

    @Test
    void oneAddressServesReloadsAndFurtherTabs() {
        browser.visit(studio.oneTimeAddress() + CHEAP + "#motion");

        browser.await("studio.state.connection === 'live'");
        assertThat(browser.evaluate("location.search + location.hash + document.cookie")
                        .getAsString())
                .isEqualTo(CHEAP.replaceFirst("&", "?") + "#motion");
        browser.visit(studio.address() + "?quality=lowest");
        browser.await("studio.state.connection === 'live'");
    }

    @Tag("slow")
    @Test
    void pageFileThatOpenersNameLetsTheBrowserIn(@TempDir Path home) throws IOException {
        String usersHome = System.setProperty("user.home", home.toString());
        try {
            browser.visit(RedirectPage.write(studio.oneTimeAddress()).toUri().toString());

            browser.await("typeof studio === 'object' && studio.state.connection === 'live'");
            assertThat(browser.evaluate("location.href").getAsString())
                    .isEqualTo(studio.address().toString());
        } finally {
            System.setProperty("user.home", usersHome);
            browser.forgetComplaints();
        }
    }

    @Test
    void usedAddressSaysHowToGetAnotherOne() {
        String used = studio.oneTimeAddress().toString().replace("127.0.0.1", "localhost");
        StudioCookie.of(URI.create(used));

        browser.visit(used);

        browser.await("document.querySelector('h1').innerText === 'This address has already been used'");
        browser.forgetComplaints();
    }
}

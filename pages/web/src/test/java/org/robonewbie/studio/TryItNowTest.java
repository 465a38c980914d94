package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The published folder has the web edition as its front page, and its documentation links to it. */
@InBrowser
@Timeout(120)
class TryItNowTest {

    private static final Path PAGE = Path.of("target", "web").toAbsolutePath();
    private static final Pattern LINK = Pattern.compile("<a class=\"try\" href=\"([^\"]*)\">Try it now</a>");

    private final Chromium browser;
    private StaticServer server;

    TryItNowTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void serve() throws IOException {
        server = new StaticServer(PAGE);
    }

    @AfterEach
    void end() {
        server.close();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"docs/index.html", "docs/tutorial/1-perception.html", "docs/exercises/de/01-raise-arms.html"})
    void linkLeadsToTheFrontPageOfWhatIsPublished(String page) throws IOException {
        Path file = PAGE.resolve(page);

        Matcher link = LINK.matcher(Files.readString(file));

        assertThat(link.find()).isTrue();
        assertThat(file.resolveSibling(link.group(1)).normalize())
                .isEqualTo(PAGE.resolve("index.html"))
                .isRegularFile();
    }

    @Test
    void documentationIsOneClickAwayFromARobot() {
        browser.visit(server.address() + "docs/index.html");
        assertThat(browser.evaluate("document.querySelector('a.try').getBoundingClientRect().height > 10")
                        .getAsBoolean())
                .isTrue();

        browser.click("a.try");

        browser.await("window.studio?.state.frame?.cycle > 50");
    }
}

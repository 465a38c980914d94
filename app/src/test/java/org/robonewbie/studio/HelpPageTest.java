package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** axe-core finds no violation in the pages of Help, light and dark; the studio alone has no such pages. */
@Tag("slow")
@InBrowser
class HelpPageTest {

    private final Chromium browser;
    private final Axe axe = new Axe();

    @TempDir
    private Path folder;

    HelpPageTest(Chromium browser) {
        this.browser = browser;
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "for/students.html", "studio.html", "competition.html", "tutorial/", "reference.html"})
    void pageHasNoViolationInLightAndDark(String page) throws IOException {
        try (FurnishedStudio studio = new FurnishedStudio(folder)) {
            for (String theme : new String[] {"light", "dark"}) {
                browser.visit(studio.oneTimeAddress() + "&theme=" + theme);
                browser.visit(studio.oneTimeAddress().replaceFirst("/\\?.*", "/docs/" + page));
                browser.await("document.querySelector('main, article, h1')");

                assertThat(axe.violations(browser)).as(theme).isEmpty();
            }
        }
    }
}

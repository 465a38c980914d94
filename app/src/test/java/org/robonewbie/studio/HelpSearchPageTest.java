package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.app.Project;

/** Readers find a page of Help by the words that they type, in the studio and in a folder without a server. */
@InBrowser
@Timeout(120)
class HelpSearchPageTest {

    private static final Path PAGES = Project.ROOT.resolve("pages/site/target/classes/org/robonewbie/site/pages");

    private final Chromium browser;
    private final Axe axe = new Axe();

    @TempDir
    private Path folder;

    HelpSearchPageTest(Chromium browser) {
        this.browser = browser;
    }

    @ParameterizedTest
    @CsvSource({
        "index.html, setJointSpeed, tutorial/2-motion.html",
        "index.html, competition rules, competition.html",
        "for/students.html, how do I install Java, installation.html",
        "tutorial/1-perception.html, kicking, exercises/12-kick.html",
        "glossary.html, exerzise, exercises/",
        "exercises/de/01-raise-arms.html, hande heben, exercises/de/01-raise-arms.html",
        "exercises/de/index.html, Schuss, exercises/de/12-kick.html"
    })
    void questionFindsItsPage(String from, String question, String answer) {
        browser.visit(PAGES.resolve(from).toUri().toString());

        ask(question);

        assertThat(browser.evaluate("document.querySelector('#found a').href").getAsString())
                .contains(answer);
        assertThat(browser.evaluate("document.querySelector('#found mark').checkVisibility()")
                        .getAsBoolean())
                .isTrue();
    }

    @Tag("slow")
    @Test
    void keyboardLeadsFromAnyPlaceToAHit() throws IOException {
        try (FurnishedStudio studio = new FurnishedStudio(folder)) {
            browser.visit(studio.oneTimeAddress());
            browser.visit(studio.oneTimeAddress().replaceFirst("/\\?.*", "/docs/for/students.html"));

            browser.press("/");
            browser.await("document.activeElement.id === 'search'");
            ask("tutorial");
            assertThat(axe.violations(browser)).isEmpty();
            browser.press("Escape");
            browser.await("!document.querySelector('#found').checkVisibility()");
            ask("glossary");
            browser.press("ArrowDown");
            browser.await("document.activeElement === document.querySelector('#found a')");
            browser.press("Enter");

            browser.await("location.pathname.endsWith('/glossary.html')");
        }
    }

    @Test
    void unknownWordIsToldInTheLanguageOfThePage() {
        browser.visit(PAGES.resolve("exercises/de/index.html").toUri().toString());

        browser.evaluate("document.querySelector('#search').focus()");
        type("qqqqqqqq");

        browser.await("document.querySelector('#found').innerText.includes('Nichts gefunden')");
    }

    private void ask(String question) {
        browser.evaluate("document.querySelector('#search').focus()");
        browser.evaluate("document.querySelector('#search').select()");
        type(question);
        browser.await("document.querySelector('#found a')?.checkVisibility()");
    }

    private void type(String text) {
        text.chars().mapToObj(Character::toString).forEach(browser::press);
    }
}

package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A student selects an exercise, runs a program, and sees the result. */
@InBrowser
class CoursePageTest {

    @TempDir
    private Path folder;

    private final Chromium browser;
    private final TestSimulator freePitch = new TestSimulator();
    private final ShownSimulation shown = new ShownSimulation(freePitch.control());
    private final SmallCourse course = new SmallCourse(shown, freePitch.control());
    private StudioServer studio;

    CoursePageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void open() throws IOException {
        StudioFolders folders = new StudioFolders(folder.resolve("motions"), Optional.empty());
        studio = StudioServer.start(shown, 0, AccessToken.random(), folders, course);
    }

    @AfterEach
    void close() {
        studio.close();
        course.close();
        freePitch.close();
    }

    private void visit() {
        visit("lowest");
    }

    private void visit(String quality) {
        browser.visit(studio.oneTimeAddress() + "&theme=light&quality=" + quality);
        browser.await("studio.state.frame && studio.view.drawCalls > 0");
        browser.await("document.querySelector(\"#rooms a[href='#field/exercises']\")?.hidden === false");
        browser.click("#rooms a[href='#field/exercises']");
        browser.await("!document.querySelector('#course').hidden");
    }

    private void chooseKick() {
        browser.click("[data-exercise=kick]");
        browser.await("document.querySelector('#course-program').options.length === 2");
    }

    @Tag("slow")
    @Test
    void listShowsTitleLevelAndPassedExercises() {
        visit();

        browser.await("document.querySelector('[data-exercise=kick]').innerText.replace(/\\s+/g, ' ') === "
                + "'2 A kick challenge · 120 min'");
        browser.await("document.querySelector('[data-exercise=arms]').innerText.replace(/\\s+/g, ' ') === "
                + "'✓ 1 Raise arms first steps · 8.5 of 10 points · 2 tries · 7 min'");
        browser.await(
                "document.querySelector('#course-sum').innerText === '1 of 2 exercises passed, 8.5 of 20 points, 7 min'");
        browser.await("document.querySelector('#course-badges').innerText === 'First success'");
        chooseKick();
        browser.await("document.querySelector('.lesson a').getAttribute('href') === 'docs/exercises/k.html'");
        assertThat(browser.complaints()).isEmpty();
    }

    @Tag("slow")
    @Test
    void hintsOpenOneAfterTheOtherAndThenASolution() {
        visit();
        chooseKick();

        browser.await("document.querySelector('#course-next-hint').innerText === 'Open hint 1 of 2'");
        browser.await("document.querySelector('#course-show-solution').disabled");
        browser.click("#course-next-hint");
        browser.await("document.querySelector('#course-next-hint').innerText === 'Open hint 2 of 2'");
        browser.await("document.querySelector('#course-open-hints').innerText.trim() === 'Look first.'");
        browser.click("#course-next-hint");
        browser.await("document.querySelector('#course-next-hint').hidden");
        browser.await("document.querySelector('#course-show-solution').innerText === 'Show me a solution'");
        browser.click("#course-show-solution");
        browser.await("document.querySelector('#course-solution').innerText.includes('class Kick')");
        assertThat(browser.complaints()).isEmpty();
    }

    @Tag("slow")
    @Test
    void starterProgramIsWrittenAndSelected() {
        visit();
        chooseKick();

        browser.click("#course-write");

        browser.await("document.querySelector('#course-program').value === 'Kick.java'");
        browser.await("document.querySelector('#course-write').hidden");
    }

    @Test
    void trialIsShownLiveAndItsVerdictBesideIt() {
        visit();
        startAttempt();

        browser.await(
                "document.querySelector('#course-judged').innerText === '✗ Seed 1: 4 points, the ball went 1.00 m'");
        browser.await("document.querySelector('#course-hints').innerText === 'Hint: Be quick.'");
        browser.await("document.querySelector('#course-progress').innerText === 'Not yet passed: 4.0 of 10 points'");
        browser.await("document.querySelector('#course-output pre').textContent === 'hello from the program'");
        browser.click("#course-stop");
        browser.await("studio.state.scene.robots.length === 0 && document.querySelector('#course-stop').hidden");
        assertThat(browser.complaints()).isEmpty();
    }

    @Tag("slow")
    @Test
    void lastTrialIsAGhostBesideTheNextOne() {
        visit();
        startAttempt();
        browser.await("document.querySelector('#course-judged').innerText.startsWith('✗ Seed 1')");
        browser.await("!studio.field.ghosts.group.visible");

        browser.click("#course-start");

        browser.await("studio.state.scene.trial.attempt === 2 && studio.field.ghosts.group.visible");
        browser.await("studio.field.ghosts.robots.scene.robots.length === 1");
        browser.click("#course-ghost");
        browser.await("!studio.field.ghosts.group.visible");
        assertThat(browser.complaints()).isEmpty();
    }

    @Tag("slow")
    @Test
    void exercisesAreTranslatedToGerman() {
        visit();
        chooseKick();

        browser.evaluate("document.querySelector('#course-language').value = 'de'");
        browser.evaluate("document.querySelector('#course-language').dispatchEvent(new Event('change'))");

        browser.await("document.querySelector('.lesson h3').innerText === '2 Ein Schuss'");
        browser.await("document.querySelector('.lesson').innerText.includes('Schieß ihn.')");
        browser.await("document.querySelector('.lesson a').getAttribute('href') === 'docs/exercises/de/k.html'");
        assertThat(browser.complaints()).isEmpty();
    }

    private void startAttempt() {
        chooseKick();
        browser.evaluate("document.querySelector('#course-program').value = 'Other.java'");

        browser.click("#course-start");
        browser.await("document.querySelector('#course-progress').innerText.includes('being graded')");
        browser.await("studio.state.scene.robots.length === 1");
        course.judge(4, "the ball went 1.00 m", "Be quick.", "hello from the program");
    }

    @Tag("slow")
    @Tag("picture")
    @Test
    void takesScreenshotOfTheExercises() throws IOException {
        studio.close();
        StudioFolders folders = new StudioFolders(folder.resolve("motions"), Optional.empty());
        studio = StudioServer.start(shown, 0, AccessToken.random(), folders, course, new SmallWorkshop(folder));
        browser.drawSharply();
        visit("high");
        startAttempt();

        browser.await("document.querySelector('#course-output pre').textContent === 'hello from the program'");
        Picture.ofDocumentation("docs/images/studio-exercises.png", browser.screenshot());
        assertThat(browser.complaints()).isEmpty();
    }

    @Tag("slow")
    @Test
    void studioWithoutExercisesDoesNotOfferThem() throws IOException {
        try (StudioServer other = StudioServer.start(freePitch.control(), 0, AccessToken.random())) {
            browser.visit(other.oneTimeAddress() + "&quality=lowest");
            browser.await("studio.state.frame && studio.view.drawCalls > 0");

            browser.await("document.querySelector(\"#rooms a[href='#field/exercises']\").hidden");
        }
    }
}

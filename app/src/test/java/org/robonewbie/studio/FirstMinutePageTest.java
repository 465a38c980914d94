package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A newcomer opens the studio for the first time. */
@InBrowser(newcomer = true)
@Timeout(300)
class FirstMinutePageTest {

    private static final String CARD = "document.querySelector('#first-minute')";
    private static final String IS_SHOWN = CARD + "?.checkVisibility()";
    private static final int CTRL = 2;

    @TempDir
    private Path folder;

    private final Chromium browser;
    private final Axe axe = new Axe();
    private ProgrammingStudio studio;

    FirstMinutePageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void open() throws IOException {
        studio = new ProgrammingStudio(folder);
    }

    @AfterEach
    void close() {
        studio.close();
    }

    private void visit(String theme) {
        browser.visit(studio.address() + "&quality=lowest&theme=" + theme);
    }

    private void awaitCard(String text) {
        browser.await(IS_SHOWN + " && " + CARD + ".innerText.includes(" + Chromium.quoted(text) + ")");
    }

    /** Inserts all lines that the editor proposes. */
    private void insertGhosts() {
        String ghost = "document.querySelector('#program-editor').shadowRoot.querySelector('.cm-ghost')";
        browser.await(ghost + " !== null");
        while (!browser.evaluate(ghost + " === null").getAsBoolean()) {
            browser.press("Tab");
        }
    }

    private void passLevel(String title) {
        awaitCard(title);
        insertGhosts();
        awaitCard("Press ▶ Run");
        browser.press("Enter", CTRL);
        awaitCard("Well done: ");
    }

    @Tag("slow")
    @Test
    void threeLevelsLeadToTheFirstExerciseByKeyboardAlone() {
        visit("light");
        browser.await("studio.state.scene?.robots.length === 1");

        passLevel("Make the robot wave");
        browser.press("Enter");
        passLevel("Make it look at the ball");
        browser.press("Enter");
        passLevel("Make it walk to the ball and kick");
        browser.press("Enter");

        browser.await("document.querySelector('#program-check') !== null");
        assertThat(browser.evaluate(IS_SHOWN).getAsBoolean()).isFalse();
        assertThat(browser.evaluate("studio.rooms.program.files.file.path").getAsString())
                .isEqualTo("RaiseArms.java");
        browser.await("studio.state.scene?.robots.length === 0");
        assertThat(folder.resolve("Wave.java")).content().contains("LEFT_SHOULDER_PITCH, 90");
        assertThat(browser.complaints()).isEmpty();
        visit("light");
        browser.await("studio.state.scene !== undefined");
        assertThat(browser.evaluate("location.hash").getAsString()).isEmpty();
    }

    @Tag("slow")
    @Test
    void levelThatIsNotPassedSaysWhatToDo() {
        visit("light");
        awaitCard("Make the robot wave");

        browser.click("#program-run");

        awaitCard("Not yet: the hand stayed");
        awaitCard("A larger angle raises the arm higher.");
        assertThat(browser.evaluate("document.querySelector('#first-minute-next').checkVisibility()")
                        .getAsBoolean())
                .isFalse();
    }

    @Tag("slow")
    @Test
    void mistakeOfTheCompilerIsFixedFirst() {
        visit("light");
        awaitCard("Make the robot wave");
        browser.await("studio.rooms.program !== undefined");
        browser.evaluate(
                "studio.rooms.program.editor.replace(studio.rooms.program.editor.text.replace(', 0)', ', x)'))");

        browser.click("#program-run");

        awaitCard("Fix the line marked in red first.");
    }

    @Tag("slow")
    @Test
    void skippedLevelsNeverReturn() {
        visit("light");
        awaitCard("Make the robot wave");

        browser.click("#first-minute-skip");

        browser.await("studio.rooms.program.files.file.path === 'MyAgent.java'");
        browser.await("studio.state.scene?.robots.length === 0");
        visit("light");
        browser.await("studio.state.scene !== undefined");
        assertThat(browser.evaluate("location.hash").getAsString()).isEmpty();
        assertThat(folder.resolve("Wave.java")).doesNotExist();
    }

    @Tag("slow")
    @Test
    void reloadedPageContinuesWithTheSameLevelAndText() {
        visit("light");
        awaitCard("Make the robot wave");
        insertGhosts();
        browser.await("studio.rooms.program?.isAtRisk === false");

        visit("light");

        awaitCard("Press ▶ Run");
        browser.press("Enter", CTRL);
        awaitCard("Well done: ");
        visit("light");
        awaitCard("Make it look at the ball");
    }

    @Test
    void levelsSpeakGerman() {
        visit("light");
        awaitCard("Make the robot wave");

        browser.click("#first-minute-language");

        awaitCard("Lass den Roboter winken");
        assertThat(browser.evaluate(CARD + ".lang").getAsString()).isEqualTo("de");
        insertGhosts();
        awaitCard("Drücke ▶ Run");
    }

    @Tag("slow")
    @Test
    void returningUserSeesTheFieldFirst() throws IOException {
        Files.writeString(folder.resolve("MyAgent.java"), "public class MyAgent {}");

        visit("light");

        browser.await("studio.state.scene !== undefined");
        browser.evaluate("location.hash = '#program'");
        browser.await("studio.rooms.program?.files?.file?.path === 'MyAgent.java'");
        assertThat(browser.evaluate(IS_SHOWN).getAsBoolean()).isFalse();
    }

    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"light, 1366", "light, 1024", "dark, 1366", "dark, 1024"})
    void levelsAreAccessibleAndWorthAPicture(String theme, int width) throws IOException {
        browser.drawSharply();
        browser.resize(width, 768);
        browser.visit(studio.address() + "&quality=high&theme=" + theme);
        for (int level = 1; level <= 3; level++) {
            awaitCard(" " + level + " / 3");
            browser.rest(2);
            picture(theme, width, level + "-start");
            assertThat(axe.violations(browser)).isEmpty();
            insertGhosts();
            awaitCard("Press ▶ Run");
            picture(theme, width, level + "-run");
            browser.click("#program-run");
            browser.rest(3);
            picture(theme, width, level + "-watch");
            awaitCard("Well done: ");
            browser.rest(1);
            picture(theme, width, level + "-passed");
            assertThat(axe.violations(browser)).isEmpty();
            browser.click("#first-minute-next");
        }
        browser.await("document.querySelector('#program-check') !== null");
        browser.rest(1);
        picture(theme, width, "4-exercise");
    }

    private void picture(String theme, int width, String name) throws IOException {
        Picture.keep("first-minute-" + theme + "-" + width + "-" + name + ".png", browser.screenshot());
    }
}

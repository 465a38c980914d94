package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Edits in the motion editor are never lost, and undo reverts what is visible. */
@Tag("slow")
@InBrowser
class MotionSafetyPageTest {

    private static final String EDITOR = "studio.motion.editor";
    private static final String FRAMES =
            EDITOR + ".state.history.present.value.lines.filter(line => line.keyframe).map(line => line.keyframe)";
    private static final String YAW = "document.querySelector('[data-joint=NECK_YAW]')";
    private static final String STANDING = "0 0 -90 10 0 -25 0 0 25 -50 25 0 0 0 25 -50 25 0 -90 -10 0 25";

    private final Chromium browser;

    @TempDir
    private Path folder;

    private final TestSimulator simulation = new TestSimulator().withRobot();
    private StudioServer studio;

    MotionSafetyPageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void start() throws IOException {
        Files.writeString(folder.resolve("mine.txt"), "500 " + STANDING + "\n");
        studio = StudioServer.start(
                simulation.control(), 0, AccessToken.random(), new StudioFolders(folder, Optional.empty()));
        open();
    }

    @AfterEach
    void close() {
        studio.close();
        simulation.close();
    }

    private void open() {
        browser.visit(studio.oneTimeAddress() + "&quality=lowest#motion/mine");
        browser.await("studio.motion && " + EDITOR + ".state.name === 'mine' && !studio.motion.stale");
    }

    private Path draft(String name) {
        return folder.resolve(".studio").resolve("drafts").resolve(name + ".txt");
    }

    /** Types into the field of the neck's yaw and keeps the focus there. */
    private void typeYaw(String text) {
        browser.evaluate("(() => { const field = " + YAW + "; field.focus(); field.value = " + Chromium.quoted(text)
                + "; field.dispatchEvent(new Event('input', {bubbles: true})); })()");
    }

    private void press(String key, boolean ctrl) {
        browser.evaluate("document.activeElement.dispatchEvent(new KeyboardEvent('keydown', {key: "
                + Chromium.quoted(key) + ", ctrlKey: " + ctrl + ", bubbles: true, cancelable: true}))");
    }

    private int undoSteps() {
        return browser.evaluate(EDITOR + ".state.history.past.length").getAsInt();
    }

    @Test
    void newMotionLeavesTheUnnamedOneBeforeItInTheList() throws IOException {
        browser.click("#new-motion");
        browser.await(EDITOR + ".state.name === '' && " + FRAMES + ".length === 1");
        browser.fill("[data-joint='NECK_YAW']", "44");
        browser.click("#new-motion");
        browser.await("document.querySelector(\"#own-motions [data-motion='new motion 1']\")");
        browser.await(FRAMES + "[0].degrees[0] === 0");
        browser.fill("[data-joint='NECK_YAW']", "-20");
        simulation.awaitTrue(() -> Files.exists(draft("new motion 2")));

        browser.click("#own-motions [data-motion='new motion 1']");

        browser.await(FRAMES + "[0].degrees[0] === 44");
        assertThat(draft("new motion 1")).content().startsWith("500 44");
        assertThat(draft("new motion 2")).content().startsWith("500 -20");
    }

    @Test
    void unnamedMotionIsSavedUnderANameAndItsDraftGoes() throws IOException {
        browser.click("#new-motion");
        browser.await(EDITOR + ".state.name === ''");
        browser.fill("[data-joint='NECK_YAW']", "44");
        simulation.awaitTrue(() -> Files.exists(draft("new motion 1")));

        browser.click("#save");
        browser.await("document.querySelector('#answer')");
        browser.fill("#answer", "look");
        browser.click("#accept");

        browser.await(EDITOR + ".state.name === 'look'");
        simulation.awaitTrue(() -> !Files.exists(draft("new motion 1")));
        assertThat(folder.resolve("look.txt")).content().startsWith("500 44");
    }

    @Test
    void arrowKeysContinueFromTypedAngles() {
        typeYaw("12,5");
        press("ArrowUp", false);
        browser.await(FRAMES + "[0].degrees[0] === 13.5");

        typeYaw("1e9");
        press("ArrowUp", false);
        browser.await("document.querySelector('#toast').textContent.startsWith('“1e9” is not an angle')");
        assertThat(browser.evaluate(FRAMES + "[0].degrees[0]").getAsDouble()).isEqualTo(13.5);
    }

    @Test
    void hugeNumbersOfAFileAreDrawnWithFewLines() throws IOException {
        Files.writeString(folder.resolve("huge.txt"), "999999999 1e9" + STANDING.substring(1) + "\n");
        browser.visit("about:blank");
        browser.visit(studio.oneTimeAddress() + "&quality=lowest#motion/huge");
        browser.await("studio.motion && " + EDITOR + ".state.name === 'huge' && !studio.motion.stale");

        browser.click("#timeline-curves");

        browser.await("document.querySelector('.track-drawing .tick-text')");
        assertThat(browser.evaluate("document.querySelectorAll('#motion-timeline .tick-text').length")
                        .getAsInt())
                .isBetween(3, 40);
    }

    @Test
    void typedAngleIsInTheFileThatIsSavedByKey() throws IOException {
        typeYaw("17");

        press("s", true);

        browser.await("document.querySelector('#toast').textContent.startsWith('Saved')");
        assertThat(folder.resolve("mine.txt")).content().startsWith("500 17");
    }

    @Test
    void typedTimeIsPlayed() {
        browser.evaluate("(() => { const field = document.querySelector('#millis'); field.focus(); field.value = '900';"
                + " field.dispatchEvent(new Event('input', {bubbles: true})); })()");

        browser.evaluate("document.querySelector('#play').click()");

        browser.await(FRAMES + "[0].millis === 900");
    }

    @Test
    void undoInTheFieldTakesBackTheAngleAndShowsTheOldOne() {
        typeYaw("35");
        press("Enter", false);
        browser.await(FRAMES + "[0].degrees[0] === 35");
        assertThat(undoSteps()).isEqualTo(1);

        press("z", true);

        browser.await(FRAMES + "[0].degrees[0] === 0 && " + YAW + ".value === '0'");
        press("y", true);
        browser.await(FRAMES + "[0].degrees[0] === 35 && " + YAW + ".value === '35'");
    }

    @Test
    void angleThatIsEnteredAndLeftIsOneStepOfUndo() {
        typeYaw("21");
        press("Enter", false);
        browser.evaluate(YAW + ".dispatchEvent(new Event('change')); " + YAW + ".blur()");

        browser.await(FRAMES + "[0].degrees[0] === 21");
        assertThat(undoSteps()).isEqualTo(1);
    }

    @Test
    void capsLockChangesNoOrder() {
        typeYaw("35");
        press("Enter", false);
        browser.await(FRAMES + "[0].degrees[0] === 35");

        press("Z", true);

        browser.await(FRAMES + "[0].degrees[0] === 0");
    }

    @Test
    void wordInANumberFieldIsRefusedWithAMessage() {
        typeYaw("abc");

        press("Enter", false);

        browser.await(
                "document.querySelector('#toast').textContent === '“abc” is not an angle in degrees: neck yaw stays as it is.'");
        browser.await(YAW + ".value === '0'");
    }

    @Test
    void unreadableLineIsReported() throws IOException {
        Files.writeString(folder.resolve("broken.txt"), "500 " + STANDING + "\nthis line is nonsense\n");

        browser.click("#own-motions [data-motion='broken']");

        browser.await("document.querySelector('.verdict').textContent.startsWith('Line 2 cannot be read')");
    }

    @Test
    void fileThatShadowsALibraryMotionShowsAWarning() throws IOException {
        Files.writeString(folder.resolve("wave.txt"), "500 " + STANDING + "\n");
        browser.click("#own-motions [data-motion='wave']");
        browser.await(EDITOR + ".state.version !== '' && " + EDITOR + ".state.name === 'wave'");
        browser.fill("[data-joint='NECK_YAW']", "44");

        browser.click("#save");

        browser.await(
                "document.querySelector('#toast').textContent.endsWith('it replaces the library motion with that name.')");
    }

    @Test
    void noteAfterSavingCoversNoKeyframe() {
        browser.fill("[data-joint='NECK_YAW']", "44");

        browser.click("#save");
        browser.await("!document.querySelector('#toast').hidden");

        assertThat(browser.evaluate("document.querySelector('#toast').getBoundingClientRect().bottom"
                                + " < document.querySelector('#play').getBoundingClientRect().top")
                        .getAsBoolean())
                .isTrue();
    }

    @Test
    void listOfMotionsKeepsItsButtonsWhenAnotherFileAppears() throws IOException {
        browser.evaluate("window.mine = document.querySelector('#own-motions [data-motion=mine]')");

        Files.writeString(folder.resolve("another.txt"), "500 " + STANDING + "\n");

        browser.await("document.querySelector('#own-motions [data-motion=another]')");
        assertThat(browser.evaluate("mine.isConnected && mine === document.querySelector('#own-motions"
                                + " [data-motion=mine]')")
                        .getAsBoolean())
                .isTrue();
    }

    @Test
    void lastTickOfTheTimelineIsReadInWhole() {
        browser.await("document.querySelectorAll('.tick-text').length > 1");

        assertThat(browser.evaluate("[...document.querySelectorAll('.tick-text')].every(tick =>"
                                + " tick.getBoundingClientRect().right <= innerWidth)")
                        .getAsBoolean())
                .isTrue();
    }

    @Test
    void wordsOfTheVerdictAreExplained() {
        assertThat(browser.evaluate("document.querySelector('.verdict').title").getAsString())
                .contains("centre of mass");
    }

    @Test
    void limbThatCannotFollowSaysWhichJointIsAtItsLimit() {
        String place = "(() => { const room = studio.motion; const { posture, torso } = room.posedNow();"
                + " const link = room.body.model.links.findIndex(({ name }) => name === 'llowerarm');"
                + " return room.stage.pageAt([...room.posesOf(posture, torso)].slice(7 * link, 7 * link + 3)).join(' ');"
                + " })()";
        String[] arm = browser.evaluate(place).getAsString().split(" ", -1);
        double x = Double.parseDouble(arm[0]);
        double y = Double.parseDouble(arm[1]);

        browser.evaluate("new MutationObserver(() => { window.signs = (window.signs ?? '')"
                + " + document.querySelector('.limit-sign').textContent; })"
                + ".observe(document.querySelector('.limit-sign'), {childList: true})");
        browser.mouse("mousePressed", x, y);
        for (int i = 0; i <= 12; i++) {
            double turn = Math.PI * i / 6;
            browser.mouse("mouseMoved", x + 170 * Math.cos(turn), y + 170 * Math.sin(turn));
            browser.await("performance.now() - studio.motion.pointer.lastDrag < 1000");
        }

        browser.await("/The left .* is at its limit/.test(window.signs)");
        browser.mouse("mouseReleased", x, y);
        browser.await("document.querySelector('.limit-sign').hidden");
    }

    @Test
    void robotInTheAirHasNoSupportAndNoMistake() {
        String place = "(() => { const room = studio.motion; const { posture, torso } = room.posedNow();"
                + " return room.stage.pageAt([...room.posesOf(posture, torso)].slice(0, 3)).join(' '); })()";
        String[] torso = browser.evaluate(place).getAsString().split(" ", -1);
        double x = Double.parseDouble(torso[0]);
        double y = Double.parseDouble(torso[1]);

        browser.mouse("mousePressed", x, y);
        for (int i = 1; i <= 6; i++) {
            browser.mouse("mouseMoved", x, y - 40 * i);
        }
        browser.await("!studio.motion.stage.marker.support.visible");
        browser.mouse("mouseReleased", x, y - 240);

        browser.await("!studio.motion.stale");
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void lostSimulatorIsReportedAndUnsavedWorkBlocksClosing() {
        studio.close();
        browser.await("!document.querySelector('#gone').hidden");
        browser.fill("[data-joint='NECK_YAW']", "44");
        browser.await("document.querySelector('#toast').textContent.includes('The draft could not be saved')");

        assertThat(isAskedBeforeClosing()).isTrue();
        browser.forgetComplaints();
    }

    @Test
    void pageClosesWithoutAQuestionIfNothingIsUnsaved() {
        browser.fill("[data-joint='NECK_YAW']", "44");
        simulation.awaitTrue(() -> Files.exists(draft("mine")));

        browser.await("!" + EDITOR + ".isAtRisk");
        assertThat(isAskedBeforeClosing()).isFalse();
    }

    private boolean isAskedBeforeClosing() {
        return browser.evaluate("!window.dispatchEvent(new Event('beforeunload', {cancelable: true}))")
                .getAsBoolean();
    }
}

package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.file.MotionFiles;
import org.robonewbie.protocol.order.Order;

/** The motion editor in a real browser with files in a real folder. */
@InBrowser
class MotionPageTest {

    private static final String STATE = "studio.motion.editor.state";
    private static final String FRAMES =
            STATE + ".history.present.value.lines.filter(line => line.keyframe).map(line => line.keyframe)";
    private static final String STANDING = "0 0 -90 10 0 -25 0 0 25 -50 25 0 0 0 25 -50 25 0 -90 -10 0 25";
    private static final String WITH_COMMENTS = "// author: Ada\r\n\r\n500\t" + STANDING
            + "   // begin\r\nnonsense\r\n1000 " + STANDING.replace("-25", "-25.500") + "\r\n";

    private final Chromium browser;

    @TempDir
    private Path folder;

    private final TestSimulator simulation = new TestSimulator().withRobot();
    private StudioServer studio;

    MotionPageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void start() throws IOException {
        studio = StudioServer.start(
                simulation.control(), 0, AccessToken.random(), new StudioFolders(folder, Optional.empty()));
    }

    @AfterEach
    void close() {
        studio.close();
        simulation.close();
    }

    private void open(String motion) {
        browser.visit(studio.oneTimeAddress() + "&quality=lowest&theme=light#motion/" + motion);
        browser.await("studio.motion && " + STATE + ".name === " + Chromium.quoted(motion));
        browser.await("!studio.motion.stale");
    }

    private void openFile(String content) throws IOException {
        Files.writeString(folder.resolve("mine.txt"), content);
        open("mine");
    }

    private double number(String expression) {
        return browser.evaluate(expression).getAsDouble();
    }

    private int frames() {
        return (int) number(FRAMES + ".length");
    }

    /** Drags between two points of the page in small steps. */
    private void drag(double fromX, double fromY, double toX, double toY) {
        browser.mouse("mousePressed", fromX, fromY);
        for (int i = 1; i <= 4; i++) {
            browser.mouse("mouseMoved", fromX + i * (toX - fromX) / 4, fromY + i * (toY - fromY) / 4);
        }
        browser.mouse("mouseReleased", toX, toY);
    }

    private double[] pageAt(String link) {
        String place = "(() => { const room = studio.motion; const { posture, torso } = room.posedNow();"
                + " const poses = room.posesOf(posture, torso);"
                + " const at = 7 * room.body.model.links.findIndex(each => each.name === " + Chromium.quoted(link)
                + ");"
                + " return room.stage.pageAt([poses[at], poses[at + 1], poses[at + 2]]).join(' '); })()";
        String[] numbers = browser.evaluate(place).getAsString().split(" ", -1);
        return new double[] {Double.parseDouble(numbers[0]), Double.parseDouble(numbers[1])};
    }

    @Tag("slow")
    @Test
    void libraryMotionIsShownWithItsKeyframes() {
        open("wave");

        assertThat(frames()).isGreaterThan(1);
        browser.await("document.querySelectorAll('[data-keyframe]').length === " + frames());
        browser.await("/[0-9.]+ cm inside the feet$/.test(document.querySelector('.verdict').textContent)");
        assertThat(browser.complaints()).isEmpty();
    }

    @Tag("slow")
    @Test
    void draggedForearmTurnsItsElbowOnly() throws IOException {
        openFile("500 " + STANDING + "\n");
        double[] hand = pageAt("llowerarm");

        drag(hand[0], hand[1], hand[0] + 5, hand[1] - 70);

        String posture = FRAMES + "[0].degrees";
        browser.await(posture + "[4] !== 0 || " + posture + "[5] !== -25");
        for (Joint joint : Joint.values()) {
            double degrees = number(posture + "[" + joint.ordinal() + "]");
            assertThat(degrees).isBetween(joint.minDegrees(), joint.maxDegrees());
            if (joint != Joint.LEFT_ARM_ROLL && joint != Joint.LEFT_ARM_YAW) {
                assertThat(degrees).isEqualTo(Double.parseDouble(STANDING.split(" ", -1)[joint.ordinal()]));
            }
        }
    }

    @Tag("slow")
    @Test
    void draggedHandTakesTheWholeArmAlongWhileShiftIsHeld() throws IOException {
        openFile("500 " + STANDING + "\n");
        double[] hand = pageAt("llowerarm");

        browser.mouse("mousePressed", hand[0], hand[1], 8);
        browser.mouse("mouseMoved", hand[0] + 30, hand[1] - 90, 8);
        browser.mouse("mouseReleased", hand[0] + 30, hand[1] - 90, 8);

        String posture = FRAMES + "[0].degrees";
        browser.await(posture + "[2] !== -90 && " + posture + "[5] !== -25");
        for (Joint joint : Joint.values()) {
            double degrees = number(posture + "[" + joint.ordinal() + "]");
            assertThat(degrees).isBetween(joint.minDegrees(), joint.maxDegrees());
            if (!joint.name().matches("LEFT_(SHOULDER|ARM).*")) {
                assertThat(degrees).isEqualTo(Double.parseDouble(STANDING.split(" ", -1)[joint.ordinal()]));
            }
        }
    }

    @Tag("slow")
    @Test
    void copiedKeyframesArePastedIntoAnotherMotion() throws IOException {
        Files.writeString(folder.resolve("other.txt"), "700 " + STANDING.replaceFirst("0 0 -90", "33 0 -90") + "\n");
        open("other");
        browser.click("#copy");
        browser.await("document.querySelector('#toast').textContent.startsWith('1 keyframe copied')");
        Files.writeString(folder.resolve("mine.txt"), WITH_COMMENTS);
        browser.await("document.querySelector('#own-motions [data-motion=mine]')");

        browser.click("#own-motions [data-motion=mine]");
        browser.await(STATE + ".name === 'mine' && !document.querySelector('#paste').disabled");
        browser.click("#paste");

        browser.await(FRAMES + ".length === 3 && " + FRAMES + "[1].degrees[0] === 33");
    }

    @Tag("slow")
    @Test
    void keptPostureIsInTheLibraryAndOnTheDisk() throws IOException {
        openFile("500 " + STANDING.replaceFirst("0 0 -90", "21 0 -90") + "\n");

        browser.click("#keep-posture");
        browser.await("document.querySelector('#answer')");
        browser.fill("#answer", "look-left");
        browser.click("#accept");

        browser.await("document.querySelector('#motion-room').textContent.includes('look-left')");
        Path postures = folder.resolve(".studio").resolve("poses.txt");
        simulation.awaitTrue(() -> Files.exists(postures));
        assertThat(postures).content().contains("look-left");
    }

    @Tag("slow")
    @Test
    void typedAngleKeepsItsDecimalsAndUndoBringsTheOldOneBack() throws IOException {
        openFile(WITH_COMMENTS);

        browser.fill("[data-joint='LEFT_KNEE_PITCH']", "-61.375");
        browser.await(FRAMES + "[0].degrees[9] === -61.375");
        browser.await("!document.querySelector('#undo').disabled");
        browser.click("#undo");
        browser.await(FRAMES + "[0].degrees[9] === -50");
        browser.await("!document.querySelector('#redo').disabled");
        browser.click("#redo");
        browser.await(FRAMES + "[0].degrees[9] === -61.375");

        browser.click("#save");
        browser.await(STATE + ".saved === " + STATE + ".history.present.value");
        assertThat(Files.readString(folder.resolve("mine.txt")))
                .isEqualTo(WITH_COMMENTS.replaceFirst("-50", "-61.375"));
    }

    @Tag("slow")
    @Test
    void unchangedFileIsSavedByteForByte() throws IOException {
        byte[] latin = ("\uFEFF" + WITH_COMMENTS).replace("Ada", "Zoë").getBytes(StandardCharsets.UTF_8);
        Files.write(folder.resolve("mine.txt"), latin);
        open("mine");

        browser.click("#save");
        browser.await("document.querySelector('#toast').textContent.startsWith('Saved')");

        assertThat(Files.readAllBytes(folder.resolve("mine.txt"))).isEqualTo(latin);
    }

    @Test
    void newMotionIsShapedPlayedSavedAndFoundByItsName() throws IOException {
        open("wave");
        browser.click("#new-motion");
        browser.await(STATE + ".name === '' && " + FRAMES + ".length === 1");
        browser.await("!studio.motion.stale");

        double[] hand = pageAt("rupperarm");
        drag(hand[0], hand[1], hand[0] - 60, hand[1] - 60);
        browser.click("#insert");
        browser.await(FRAMES + ".length === 2");
        browser.fill("[data-joint='NECK_YAW']", "30");
        browser.click("#duplicate");
        browser.await(FRAMES + ".length === 3");
        browser.fill("#millis", "240");
        browser.click("#play");
        browser.await("!" + STATE + ".playing && " + STATE + ".time === 1240");
        browser.click("#save");
        browser.await("document.querySelector('#answer')");
        browser.fill("#answer", "my-first");
        browser.click("#accept");
        browser.await(STATE + ".name === 'my-first'");

        Motion motion = MotionFiles.load(folder.resolve("my-first.txt")).motion();
        assertThat(motion.keyframes()).hasSize(3);
        assertThat(motion.durationMillis()).isEqualTo(1240);
        assertThat(motion.keyframes().get(1).posture().degrees(Joint.NECK_YAW)).isEqualTo(30);
        browser.await("document.querySelector('#own-motions [data-motion=my-first]')");
        assertThat(browser.complaints()).isEmpty();
    }

    @Tag("slow")
    @Test
    void newMotionIsNotReplacedByOneThatArrivesLate() throws IOException {
        Files.writeString(folder.resolve("mine.txt"), WITH_COMMENTS);
        String script =
                browser.runBeforePages("(() => { const ask = window.fetch; window.fetch = async (...request) => {"
                        + " if (String(request[0]).endsWith('library/wave')) { await new Promise(go => { window.answer = go; }); }"
                        + " return ask(...request); }; })()");
        try {
            browser.visit(studio.oneTimeAddress() + "&quality=lowest#motion/wave");
            browser.await("window.answer");
            browser.click("#new-motion");
            browser.await("window.answer() ?? studio.motion");
        } finally {
            browser.forgetScript(script);
        }

        browser.await("!studio.motion.stale");
        assertThat(browser.evaluate(STATE + ".name").getAsString()).isEmpty();
        assertThat(frames()).isEqualTo(1);
    }

    @Tag("slow")
    @Test
    void physicalRobotFallsWhenTheMotionThrowsItOver() throws IOException {
        openFile("200 " + STANDING.replaceFirst("25 -50 25", "90 -50 60").replaceFirst("25 -50 25", "90 -50 60")
                + "\n1000 " + STANDING.replaceFirst("25 -50 25", "90 -50 60").replaceFirst("25 -50 25", "90 -50 60")
                + "\n");

        browser.click("#trial");

        browser.await(STATE + ".trial");
        assertThat(number(STATE + ".trial.fallSeconds")).isBetween(0.2, 2.2);
        browser.await("document.querySelector('.verdict').textContent.includes('falls after')");
    }

    @Tag("slow")
    @Test
    void physicalRobotStaysOnItsFeetWhenItStands() throws IOException {
        openFile("500 " + STANDING + "\n");

        browser.click("#trial");

        browser.await(STATE + ".trial");
        assertThat(browser.evaluate(STATE + ".trial.fallSeconds === undefined").getAsBoolean())
                .isTrue();
    }

    @Tag("slow")
    @Test
    void unsavedWorkIsRecoveredAfterACrash() throws IOException {
        openFile(WITH_COMMENTS);
        browser.fill("[data-joint='NECK_PITCH']", "12.5");
        browser.await("document.querySelector('#file-name').textContent === 'mine •'");
        Path draft = folder.resolve(".studio").resolve("drafts").resolve("mine.txt");
        simulation.awaitTrue(() -> Files.exists(draft));

        browser.visit("about:blank");
        open("mine");

        assertThat(number(FRAMES + "[0].degrees[1]")).isEqualTo(12.5);
        assertThat(Files.readString(folder.resolve("mine.txt"))).isEqualTo(WITH_COMMENTS);
        browser.await("!document.querySelector('#undo').disabled");
        browser.click("#undo");
        browser.await(FRAMES + "[0].degrees[1] === 0");
    }

    @Tag("slow")
    @Test
    void changeOfTheFileByAnotherProgramIsShownAtOnce() throws IOException {
        openFile(WITH_COMMENTS);

        Files.writeString(folder.resolve("mine.txt"), "700 " + STANDING + "\n");

        browser.await(FRAMES + ".length === 1 && " + FRAMES + "[0].millis === 700");
    }

    @Tag("slow")
    @Test
    void conflictIsResolvedByTheUser() throws IOException {
        openFile(WITH_COMMENTS);
        browser.fill("[data-joint='NECK_PITCH']", "12.5");
        Files.writeString(folder.resolve("mine.txt"), "700 " + STANDING + "\n");
        browser.await("!document.querySelector('#disk-conflict').hidden");
        browser.click("#save");
        browser.await("document.querySelector('#toast').textContent.includes('changed by another program')");

        browser.click("#load-theirs");
        browser.await(FRAMES + "[0].millis === 700");
        browser.await("!document.querySelector('#undo').disabled");
        browser.click("#undo");

        browser.await(FRAMES + "[0].degrees[1] === 12.5");
    }

    @Tag("slow")
    @Test
    void draggedKeyframeChangesItsTime() throws IOException {
        openFile(WITH_COMMENTS);
        String box = "document.querySelector('[data-keyframe=\"1\"] .diamond').getBoundingClientRect()";
        double x = number(box + ".x + 6");
        double y = number(box + ".y + 6");

        drag(x, y, x - 100, y);

        browser.await(FRAMES + "[1].millis < 1000 && " + FRAMES + "[1].millis % 20 === 0");
    }

    @Tag("slow")
    @Test
    void tooFastWayIsMarked() throws IOException {
        openFile("500 " + STANDING + "\n20 " + STANDING.replaceFirst("0 0 -90", "90 0 -90") + "\n");

        browser.await("document.querySelector('.mark.speed title')?.textContent"
                + " === 'neck yaw turns 90° in 20 ms; its motor needs 260 ms. Click to go there.'");
    }

    @Tag("slow")
    @Test
    void postureOfARunBecomesAKeyframe() throws IOException {
        openFile("500 " + STANDING + "\n");
        simulation.order(new Order.Pause());
        simulation.awaitTrue(() -> simulation.latest().paused());
        long end = simulation.latest().cycle() + 150;
        simulation.order(new Order.Step(150));
        browser.await("studio.state.frame?.paused && studio.state.frame.cycle >= " + end);

        browser.click("#take-posture");

        browser.await(FRAMES + ".length === 2");
        double knee = simulation.latest().robots().get(0).body().hingeDegrees()[Joint.COUNT - 3];
        assertThat(number(FRAMES + "[1].degrees[9]")).isCloseTo(knee, within(0.1));
    }

    @Tag("slow")
    @Test
    void allButtonsHaveReadableLettersAndNames() {
        open("wave");

        assertThat(browser.evaluate(
                                "[...document.querySelectorAll('#motion-room *')].filter(each =>"
                                        + " each.textContent.trim() && parseFloat(getComputedStyle(each).fontSize) < 12).length")
                        .getAsInt())
                .isZero();
        assertThat(browser.evaluate("[...document.querySelectorAll('#motion-room button')].filter(each =>"
                                + " !each.textContent.trim()).length")
                        .getAsInt())
                .isZero();
        assertThat(List.of(
                        number("document.documentElement.scrollWidth"),
                        number("document.documentElement.scrollHeight")))
                .containsExactly(1366.0, 768.0);
    }
}

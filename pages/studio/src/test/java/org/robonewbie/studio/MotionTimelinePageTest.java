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
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.file.MotionFiles;

/** Timeline of the motion editor with mouse and keys: rows and curves of joints, selection of several keyframes, warning marks. */
@Tag("slow")
@InBrowser(width = 1024)
class MotionTimelinePageTest {

    private static final String STATE = "studio.motion.editor.state";
    private static final String FRAMES =
            STATE + ".history.present.value.lines.filter(line => line.keyframe).map(line => line.keyframe)";
    private static final String WAYS = FRAMES + ".map(frame => frame.millis).join(' ')";
    private static final String STEPS = STATE + ".history.past.length";
    private static final int KEY_YAW_ROW = 0;
    private static final int ALT = 1;
    private static final int CONTROL = 2;
    private static final int SHIFT = 8;

    private final Chromium browser;

    @TempDir
    private Path folder;

    private final TestSimulator simulation = new TestSimulator().withRobot();
    private StudioServer studio;

    MotionTimelinePageTest(Chromium browser) {
        this.browser = browser;
    }

    /** Five keyframes, 400 ms apart, whose neck yaw is 0, 10, 20, 30 and 40. */
    @BeforeEach
    void open() throws IOException {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < 5; i++) {
            text.append("400 ").append(10 * i).append(" 0 -90 10 0 -25 0 0 25 -50 25 0 0 0 25 -50 25 0 -90 -10 0 25\n");
        }
        Files.writeString(folder.resolve("mine.txt"), text);
        studio = StudioServer.start(
                simulation.control(), 0, AccessToken.random(), new StudioFolders(folder, Optional.empty()));
        browser.visit(studio.oneTimeAddress() + "&quality=lowest&theme=light#motion/mine");
        browser.await("studio.motion && " + STATE + ".name === 'mine' && !studio.motion.stale"
                + " && studio.motion.editor.marks.length > 0 && document.querySelector('.mark')");
    }

    @AfterEach
    void close() {
        studio.close();
        simulation.close();
    }

    private double number(String expression) {
        return browser.evaluate(expression).getAsDouble();
    }

    private double x(double millis) {
        return number(
                "document.querySelector('.track-drawing').getBoundingClientRect().x + studio.motion.timeline.scale.x("
                        + millis + ")");
    }

    /** The middle of a joint's row. */
    private double y(int row) {
        return number("document.querySelector('.track-drawing').getBoundingClientRect().y + 9 + 18 * " + row);
    }

    private void drag(double fromX, double fromY, double toX, double toY, int modifiers) {
        browser.mouse("mousePressed", fromX, fromY, modifiers);
        for (int i = 1; i <= 4; i++) {
            browser.mouse("mouseMoved", fromX + i * (toX - fromX) / 4, fromY + i * (toY - fromY) / 4, modifiers);
        }
        browser.mouse("mouseReleased", toX, toY, modifiers);
    }

    private void focusTimeline() {
        browser.evaluate("document.querySelector('#motion-timeline').focus()");
    }

    @Test
    void keyframesInABoxAreMovedByKeysAndComeBackStepByStep() {
        drag(x(600), y(0), x(1400), y(1), 0);
        browser.await(STATE + ".chosen.join() === '1,2' && " + STATE + ".rows.join() === '0,1'");
        browser.await("document.querySelector('.verdict').textContent.startsWith('2 joints in 2 keyframes selected')");
        focusTimeline();

        browser.press("ArrowRight", CONTROL);
        browser.await(WAYS + " === '400 420 400 400 400'");
        browser.press("ArrowLeft", ALT | SHIFT);
        browser.await(WAYS + " === '400 320 400 500 400'");
        browser.press("ArrowUp", CONTROL | SHIFT);
        browser.await(FRAMES + ".map(frame => frame.degrees[0]).join() === '0,20,30,30,40'");

        assertThat(number(STEPS)).isEqualTo(3);
        browser.press("z", CONTROL);
        browser.press("z", CONTROL);
        browser.await(WAYS + " === '400 420 400 400 400'");
    }

    @Test
    void rowsStayUnderTheMouseUntilItLetsGoWhenAMarkComes() {
        String top = "document.querySelector('.track-drawing').getBoundingClientRect().y";
        double before = number(top);

        browser.mouse("mousePressed", x(2000), y(3));
        browser.mouse("mouseMoved", x(1800), y(3));
        browser.mouse("mouseMoved", x(1620), y(3));
        browser.await("studio.motion.editor.marks.some(mark => mark.kind === 'speed') && !studio.motion.stale");
        assertThat(number(top)).isEqualTo(before);
        browser.mouse("mouseReleased", x(1620), y(3));

        browser.await("document.querySelector('.mark.speed') && " + top + " > " + before);
    }

    @Test
    void keyframeIsDraggedAloneWhileAltIsHeldOrTheSwitchIsOn() {
        drag(x(800), y(3), x(900), y(3), ALT);
        browser.await(WAYS + " === '400 500 300 400 400'");
        assertThat(number(STEPS)).isEqualTo(1);

        browser.click("#alone");
        browser.await(STATE + ".alone");
        drag(x(900), y(3), x(800), y(3), 0);
        browser.await(WAYS + " === '400 400 400 400 400'");
        browser.click("#alone");
        browser.await("!" + STATE + ".alone");
        drag(x(800), y(3), x(900), y(3), 0);

        browser.await(WAYS + " === '400 500 400 400 400'");
    }

    @Test
    void pointOfACurveIsDraggedToAnotherAngle() {
        browser.click("#timeline-curves");
        browser.await(STATE + ".layout === 'curves' && document.querySelectorAll('.point').length === 5");
        browser.await("studio.motion.timeline.angles");
        String angle =
                "document.querySelector('.track-drawing').getBoundingClientRect().y + studio.motion.timeline.angles.y(";

        drag(x(800), number(angle + "10)"), x(800) + 2, number(angle + "25)"), 0);

        browser.await("Math.abs(" + FRAMES + "[1].degrees[" + KEY_YAW_ROW + "] - 25) < 1");
        assertThat(browser.evaluate(WAYS).getAsString()).isEqualTo("400 400 400 400 400");
        assertThat(number(STEPS)).isEqualTo(1);
    }

    @Test
    void wheelZoomsAtTheMouseAndResetShowsTheWholeMotion() {
        double before = x(1200);
        browser.evaluate("document.querySelector('.timeline-head').dispatchEvent(new WheelEvent('wheel', {deltaY: -500,"
                + " clientX: " + before + ", clientY: innerHeight - 200, bubbles: true, cancelable: true}))");
        browser.await(STATE + ".view.span > 0 && " + STATE + ".view.span < 1500 && !studio.motion.stale");
        assertThat(x(1200)).isBetween(before - 2, before + 2);

        focusTimeline();
        browser.press("End");
        browser.await(STATE + ".last === 4 && " + STATE + ".view.from + " + STATE + ".view.span >= 2000");
        browser.press("0");

        browser.await(STATE + ".view.span === 0");
    }

    @Test
    void clickOnAMarkJumpsToItAndShowsTheProblem() {
        focusTimeline();
        browser.press("End");
        browser.fill("[data-joint='LEFT_KNEE_PITCH']", "-140");
        browser.await("document.querySelector('.mark.range title')?.textContent"
                + " === 'left knee pitch at -140° is beyond -130° to 1°. Click to go there.'");
        focusTimeline();
        browser.press("Home");
        browser.await(STATE + ".last === 0");

        String mark = "document.querySelector('.mark.range').getBoundingClientRect()";
        browser.mouse("mousePressed", number(mark + ".x + 3"), number(mark + ".y + 3"));
        browser.mouse("mouseReleased", number(mark + ".x + 3"), number(mark + ".y + 3"));

        browser.await(STATE + ".last === 4 && " + STATE + ".joint === 9");
        browser.await("document.querySelector('.verdict').textContent.includes('-140° is beyond')");
        focusTimeline();
        browser.press("Home");
        browser.press("w");
        browser.await(STATE + ".time > 1500");
    }

    @Test
    void motionIsMadeBalancedInOneStepAndSaysWhereThatIsNotPossible() {
        browser.fill("[data-joint='LEFT_FOOT_PITCH']", "4");
        browser.fill("[data-joint='RIGHT_FOOT_PITCH']", "4");
        focusTimeline();
        browser.press("End");
        browser.await(STATE + ".last === 4");
        browser.fill("[data-joint='LEFT_HIP_PITCH']", "100");
        browser.fill("[data-joint='RIGHT_HIP_PITCH']", "100");
        browser.fill("[data-joint='LEFT_FOOT_PITCH']", "75");
        browser.fill("[data-joint='RIGHT_FOOT_PITCH']", "75");
        browser.await("studio.motion.editor.marks.some(mark => mark.kind === 'balance' && mark.from < 500)");
        double steps = number(STEPS);

        browser.click("#balance");

        browser.await("document.querySelector('.places button').textContent.startsWith('Keyframe 5: ')");
        assertThat(number(STEPS)).isEqualTo(steps + 1);
        browser.click(".places button");
        browser.await("!document.querySelector('dialog[open]') && " + STATE + ".last === 4");
        browser.await("!studio.motion.editor.marks.some(mark => mark.kind === 'balance' && mark.from < 500)");
        browser.click("#undo");
        browser.await(FRAMES + "[0].degrees[10] === 4");
    }

    @Test
    void pictureColoursTheLimbThatCannotFollowAndSaysWhy() {
        String shank = "studio.motion.stage.paint.shapes[studio.motion.body.model.links.findIndex("
                + "link => link.name === 'lshank')].visible";

        browser.fill("[data-joint='LEFT_KNEE_PITCH']", "-140");

        browser.await("document.querySelector('.fault-list .range')?.textContent"
                + " === 'left knee pitch at -140° is beyond -130° to 1°'");
        browser.await(shank);
        browser.click("#undo");
        browser.await("!document.querySelector('.fault-list .range') && !" + shank);
    }

    @Test
    void trialShowsWhereTheRobotIsBehindThePlan() {
        browser.fill("[data-joint='LEFT_SHOULDER_PITCH']", "60");
        browser.click("#trial");

        browser.await(
                "document.querySelector('#toast').textContent.includes('Largest lag behind the plan: left shoulder pitch')");
        browser.await("document.querySelectorAll('.late').length > 0");
        browser.click("#timeline-curves");
        browser.evaluate("document.querySelector('[data-row=\"2\"]').click()");
        browser.await("document.querySelector('[data-curve=\"2\"] .reached')");
        browser.await(STATE + ".watching && studio.motion.stage.ghosts.group.visible");
        browser.click("#watching");

        browser.await("!" + STATE + ".watching && " + STATE + ".trial && studio.motion.stage.ghosts.group.visible");
    }

    private void tabTo(String what) {
        for (int i = 0; i < 400; i++) {
            if (browser.evaluate("document.activeElement.matches(" + Chromium.quoted(what) + ")")
                    .getAsBoolean()) {
                return;
            }
            browser.press("Tab");
        }
        throw new AssertionError("The Tab key does not reach " + what);
    }

    private void type(String text) {
        text.chars().forEach(letter -> browser.press(Character.toString(letter)));
    }

    @Test
    void keyboardAloneMakesANewMotionSavesItAndPlaysIt() throws IOException {
        tabTo("#new-motion");
        browser.press("Enter");
        browser.await(STATE + ".name === '' && " + FRAMES + ".length === 1");
        tabTo("[data-joint=LEFT_SHOULDER_PITCH]");
        type("60");
        tabTo("[data-slider=LEFT_SHOULDER_YAW]");
        browser.press("i");
        browser.await(FRAMES + ".length === 2");
        tabTo("[data-joint=LEFT_SHOULDER_YAW]");
        type("75");
        tabTo("#motion-timeline");
        browser.press("ArrowRight", CONTROL | SHIFT);
        browser.await(WAYS + " === '500 600'");
        browser.press("s", CONTROL);
        browser.await("document.querySelector('#answer')");
        type("keys-only");
        browser.press("Enter");
        browser.await(STATE + ".name === 'keys-only' && !document.querySelector('dialog[open]')");
        browser.press(" ");
        browser.await(STATE + ".playing");
        browser.await("!" + STATE + ".playing && " + STATE + ".time === 1100");

        Motion motion = MotionFiles.load(folder.resolve("keys-only.txt")).motion();
        assertThat(motion.durationMillis()).isEqualTo(1100);
        assertThat(motion.keyframes().get(0).posture().degrees(Joint.LEFT_SHOULDER_PITCH))
                .isEqualTo(60);
        assertThat(motion.keyframes().get(1).posture().degrees(Joint.LEFT_SHOULDER_YAW))
                .isEqualTo(75);
    }

    @Test
    void barsTakeOneRowEachOnASmallScreen() {
        for (String bar : new String[] {"#motion-tools", "#motion-transport"}) {
            String place = "document.querySelector('" + bar + "')";
            assertThat(number(place + ".clientHeight")).as(bar).isLessThan(48);
            assertThat(number(place + ".scrollWidth")).as(bar).isEqualTo(1024);
        }

        browser.clickElement("document.querySelector('.unfolding .menu-head')");

        browser.await("document.querySelector('#duplicate').checkVisibility()");
        browser.click("#duplicate");
        browser.await(FRAMES + ".length === 6 && !document.querySelector('#duplicate').checkVisibility()");
    }
}

package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.telemetry.BelievedThing;
import org.robonewbie.protocol.telemetry.Drawing;
import org.robonewbie.protocol.telemetry.TelemetryItem;
import org.robonewbie.protocol.telemetry.TelemetryMessage;

/** The room of one robot in a real browser with telemetry. */
@InBrowser
class RobotPageTest {

    private static final String TEAM = "Blue_Newbies";
    private final Chromium browser;

    private final TestSimulator simulation =
            new TestSimulator().withRobot().withRobot(RobotType.TYPE_4, TeamSide.LEFT, 2, -3, -1, 40, Posture.GREETING);
    private StudioServer studio;

    RobotPageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void open() throws IOException {
        studio = StudioServer.start(simulation.control(), 0, AccessToken.random());
        browser.visit(studio.oneTimeAddress() + "&quality=lowest&theme=light#robot");
        browser.await("document.querySelector('#robot-choice')?.options.length === 2");
        browser.await("studio.robot.watch.watched !== '' && document.querySelectorAll('.joint-row').length === 22");
    }

    @AfterEach
    void close() {
        studio.close();
        simulation.close();
    }

    private void tell(int number, double seconds, TelemetryItem item) {
        studio.telemetry().accept(new TelemetryMessage(TEAM, number, seconds, item));
    }

    /** Repeats a message until the page shows it, since only log entries are kept for pages that subscribe later. */
    private void tellUntil(String condition, TelemetryItem item) {
        double now = now();
        simulation.awaitTrue(() -> {
            tell(1, now, item);
            return browser.evaluate("Boolean(" + condition + ")").getAsBoolean();
        });
    }

    /** Pauses the world and returns when the page shows it. */
    private void pause() {
        simulation.order(new Order.Pause());
        browser.await("studio.state.frame.paused");
    }

    @Test
    void jointsOfTheRunningRobotAreShown() {
        browser.await("[...document.querySelectorAll('.joint-row')].some(row =>"
                + " row.textContent.includes('Knee pitch') && Math.abs(parseFloat(row.querySelector('.angle').textContent)"
                + " - studio.state.frame.robots[0].degrees[studio.state.scene.models.TYPE_0.hinges.findIndex(hinge =>"
                + " hinge.joint === 'LEFT_KNEE_PITCH')]) < 3)");
        browser.await("document.querySelector('.robot-facts').textContent.includes('standing')");
        browser.await("document.querySelectorAll('.plot canvas').length === 4");
        assertThat(browser.evaluate("document.querySelector('#robot-room').textContent.includes('-0°')")
                        .getAsBoolean())
                .isFalse();
        assertThat(browser.complaints()).isEmpty();
    }

    @Tag("slow")
    @Test
    void robotShowsItsTelemetry() {
        pause();
        double now = now();

        tell(1, now, new TelemetryItem.LogEntry("WARNING", "the ball is <b>far</b>"));
        tell(1, now, new TelemetryItem.MotionProgress("walk-forward", 3));

        browser.await("document.querySelector('.log .warning')?.textContent.includes('<b>far</b>')");
        browser.await("document.querySelector('.robot-motion').textContent"
                + " === 'Motion walk-forward, moving to keyframe 3'");
        tellUntil(
                "document.querySelector('[data-value=\"agent/courage\"]')", new TelemetryItem.PlotValue("courage", 7));
        tellUntil(
                "document.querySelector('.map .belief.ball')",
                new TelemetryItem.Belief(
                        List.of(new BelievedThing("ball", new Vector3(1, 0.2, -0.4), 0, true)),
                        Optional.of(new Pose2d(-0.5, 0.4, 20))));
        browser.await("document.querySelectorAll('.map .belief.ball').length === 1");
        browser.await("document.querySelectorAll('.map .belief-self').length === 1");
        browser.await("document.querySelectorAll('.map .truth').length === 6");
    }

    @Tag("slow")
    @Test
    void onlyTheWatchedRobotIsSent() {
        browser.press("n");
        browser.await("studio.robot.watch.watched.endsWith('2')");
        browser.await("document.querySelectorAll('.joint-row').length === 24");

        simulation.awaitTrue(() -> {
            tell(1, 1, new TelemetryItem.LogEntry("INFO", "one"));
            tell(2, 1, new TelemetryItem.LogEntry("INFO", "two"));
            return browser.evaluate("document.querySelector('.log').textContent.includes('two')")
                    .getAsBoolean();
        });

        assertThat(browser.evaluate("document.querySelector('.log').textContent")
                        .getAsString())
                .doesNotContain("one");
    }

    @Tag("slow")
    @Test
    void drawingsOfOlderCyclesVanish() {
        pause();
        tellUntil(
                "document.querySelectorAll('.map .drawing').length === 1",
                new TelemetryItem.Picture(List.of(new Drawing.Circle(Vector3.ZERO, 1, "red"))));

        simulation.order(new Order.Resume());

        browser.await("document.querySelectorAll('.map .drawing').length === 0");
    }

    @Tag("slow")
    @Test
    void logIsFilteredByLevel() {
        tell(1, now(), new TelemetryItem.LogEntry("DEBUG", "detail"));
        tell(1, now(), new TelemetryItem.LogEntry("ERROR", "mistake"));
        browser.await("document.querySelectorAll('.log li').length === 2");

        browser.fill("#log-level", "WARNING");

        browser.await("document.querySelector('.log').textContent.includes('mistake')"
                + " && !document.querySelector('.log').textContent.includes('detail')");
    }

    @Tag("slow")
    @Test
    void valuesOfTheTreeAreDrawnTogetherHeldAndSavedAsTable() {
        browser.click("#add-plot");
        for (String value : List.of("torso/x", "joint angle/neck yaw")) {
            browser.click("[data-value=\"" + value + "\"]");
        }
        browser.await("studio.robot.plots.rows[4]?.plot?.series.length === 3");
        browser.await("studio.robot.plots.rows[4].plot.data[2].length > 10");
        browser.await("studio.robot.plots.moment.seconds > 1"); // curves show at least one second

        browser.click("#hold-curves");
        browser.await("studio.robot.plots.rows[4].plot.scales.x.max === studio.robot.plots.heldAt");
        double end = browser.evaluate("studio.robot.plots.heldAt").getAsDouble();
        browser.await("studio.robot.plots.moment.seconds > " + (end + 0.5));

        assertThat(browser.evaluate("studio.robot.plots.rows[4].plot.scales.x.max")
                        .getAsDouble())
                .isEqualTo(end);
        browser.evaluate("(() => { URL.createObjectURL = blob => { window.saved = blob; return '#'; }; })()");
        browser.click("#curves-csv");
        browser.await("window.saved");
        browser.evaluate("saved.text().then(text => { window.table = text; })");
        browser.await("window.table?.includes('seconds,') && window.table.includes('joint angle/neck yaw')");
    }

    @Tag("slow")
    @Test
    void allRoomsFollowTheCursorWhileTheSimulationRuns() {
        double then = now();
        tell(1, then, new TelemetryItem.LogEntry("INFO", "here I was"));
        browser.await("studio.cursor.history.last * 0.02 > " + (then + 1));

        browser.clickElement("[...document.querySelectorAll('.log-time')].find(each =>"
                + " each.parentElement.textContent.includes('here I was'))");

        browser.await("document.querySelector('#time-line').dataset.tense === 'past'");
        browser.await("Math.abs(studio.robot.plots.moment.seconds - " + then + ") < 0.06");
        browser.evaluate("location.hash = 'field'");
        browser.await("Math.abs(parseFloat(document.querySelector('#transport .seconds').textContent) - " + then
                + ") < 0.06");
        assertThat(browser.evaluate("studio.state.frame.cycle * 0.02").getAsDouble())
                .isGreaterThan(then + 0.9);
        browser.press("End");
        browser.await("document.querySelector('#time-line').dataset.tense === 'live'");
        browser.await("parseFloat(document.querySelector('#transport .seconds').textContent) > " + (then + 1));
    }

    @Tag("slow")
    @Tag("picture")
    @Test
    void takesScreenshotOfTheRoom(@TempDir Path folder) throws IOException {
        browser.drawSharply();
        try (PlayingRobot robot = PlayingRobot.start();
                WholeStudio other = new WholeStudio(robot.simulator().control(), folder)) {
            browser.visit(other.oneTimeAddress() + "&quality=high&theme=light#robot");
            browser.await("document.querySelectorAll('.plot canvas').length === 4");
            browser.await(
                    "document.querySelectorAll('.camera .post').length + document.querySelectorAll('.field-line').length > 3");
            browser.await(
                    "[...document.querySelectorAll('.senses dd')].some(each => each.textContent.includes('step'))");
            browser.await("document.querySelectorAll('.command.limit').length === 1");
            browser.await("document.querySelectorAll('.press').length === 2");
            for (String value : List.of("commanded speed/neck pitch", "joint speed/neck pitch")) {
                browser.click("[data-value=\"" + value + "\"]");
            }
            browser.await("studio.robot.plots.moment.seconds > 4");
            robot.simulator().control().order(new Order.Pause());
            browser.await("studio.state.frame.paused && studio.robot.plots.moment.frame === studio.state.frame");
            List<BelievedThing> things = List.of(new BelievedThing("ball", new Vector3(1.9, -0.2, -0.4), 0.1, true));
            double now = browser.evaluate("studio.robot.plots.moment.seconds").getAsDouble();
            TelemetryItem belief = new TelemetryItem.Belief(things, Optional.of(new Pose2d(-1.6, 0.3, 10)));
            for (int i = 0; i < 6; i++) {
                TelemetryItem line =
                        new TelemetryItem.LogEntry(i == 4 ? "WARNING" : "INFO", "I have nodded " + i + " times");
                other.telemetry().accept(new TelemetryMessage("Stars", 1, i, line));
            }
            TelemetryItem motion = new TelemetryItem.MotionProgress("nod", 3);
            other.telemetry().accept(new TelemetryMessage("Stars", 1, 1, motion));
            other.telemetry().accept(new TelemetryMessage("Stars", 1, now, belief));
            browser.await("document.querySelectorAll('.map .belief-self').length === 1");
            Picture.ofDocumentation("docs/images/studio-robot.png", browser.screenshot());

            browser.press("m");
            browser.await("document.querySelector('#perceptor-message').textContent.includes('(GYR (n torso)')");
            browser.fill("#message-search", "lae1");
            browser.await("!document.querySelector('#perceptor-message').textContent.includes('GYR')"
                    + " && document.querySelector('#effector-message').textContent.includes('(lae1 9.5)')");
            Picture.keep("studio-robot-messages.png", browser.screenshot());
        }

        assertThat(browser.evaluate("document.documentElement.scrollWidth").getAsInt())
                .isEqualTo(1366);
        assertThat(browser.complaints()).isEmpty();
    }

    private double now() {
        return browser.evaluate("studio.state.frame.cycle * 0.02").getAsDouble();
    }

    @Tag("slow")
    @Test
    void emptyLogSaysHowToWriteIntoIt() {
        browser.await("document.querySelector('#log-sheet p')?.checkVisibility()"
                + " && document.querySelector('#log-level').hidden");

        tellUntil("document.querySelector('.log li')", new TelemetryItem.LogEntry("INFO", "I see the ball"));

        browser.await("document.querySelector('#log-sheet p').hidden && !document.querySelector('#log-level').hidden");
    }

    @Tag("slow")
    @Test
    void namesInTheCameraPictureAreNotPrintedOverEachOther() {
        String overlaps = browser.evaluate("""
                import('./robot/camera-picture.js').then(({ cameraPicture }) => {
                  const place = document.querySelector('#robot-surroundings');
                  const player = (metres, left) => ({ name: `Blue ${metres}`, kind: 'player', team: 'Blue',
                    points: [{ name: 'head', polar: [metres, left, 0] }] });
                  cameraPicture(place)({ lines: [], things: Array.from({ length: 22 }, (_, i) => player(9 - i / 4, i)) }, 'Blue');
                  const names = [...place.querySelectorAll(':scope > svg text')].filter((name) => !name.hasAttribute('hidden'));
                  const boxes = names.map((name) => name.getBoundingClientRect()).filter(({ width }) => width > 0);
                  const covered = boxes.filter((a, i) => boxes.some((b, j) => j < i && a.left < b.right && b.left < a.right
                    && a.top < b.bottom && b.top < a.bottom));
                  return `${covered.length} of ${boxes.length}`;
                })""").getAsString();

        assertThat(overlaps).startsWith("0 of ").isNotEqualTo("0 of 0");
    }

    @Tag("slow")
    @Test
    void pictureCurvesJointsAndWordsAreSeenTogetherOnASmallScreen() {
        browser.resize(1024, 768);
        try {
            browser.await(
                    "innerWidth === 1024 && ['#stage canvas', '#robot-curves .plot-row', '.joint-row', '#log-tab']"
                            + ".every(each => { const box = document.querySelector(each).getBoundingClientRect();"
                            + " return box.width > 30 && box.left >= 0 && box.right <= 1024 && box.top >= 0 && box.top < 740; })");
        } finally {
            browser.resize(1366, 768);
        }
    }
}

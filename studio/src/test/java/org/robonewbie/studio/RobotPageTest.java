package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.telemetry.BelievedThing;
import org.robonewbie.protocol.telemetry.TelemetryItem;
import org.robonewbie.protocol.telemetry.TelemetryMessage;

/** The room of one robot as people have it: in a real browser, with what robots tell. */
class RobotPageTest {

    private static final String TEAM = "Blue Newbies";
    private static Chromium browser;

    private final SmallSimulation simulation = new SmallSimulation()
            .withRobot()
            .withRobot(RobotType.TYPE_4, TeamSide.LEFT, 2, -3, -1, 40, Posture.GREETING);
    private StudioServer studio;

    @BeforeAll
    static void openBrowser() throws IOException {
        Tool.BROWSER.orSkip();
        browser = Chromium.open(1366, 768);
    }

    @AfterAll
    static void closeBrowser() {
        if (browser != null) {
            browser.close();
        }
    }

    @BeforeEach
    void open() throws IOException {
        studio = StudioServer.start(simulation.start(), 0, AccessToken.random());
        browser.visit(studio.address() + "&quality=lowest&theme=light#robot");
        browser.await("document.querySelector('#robot-choice')?.options.length === 2");
        browser.await("studio.robot.watched !== '' && document.querySelectorAll('.joint-row').length === 22");
    }

    @AfterEach
    void close() {
        browser.visit("about:blank");
        browser.forgetComplaints();
        studio.close();
        simulation.close();
    }

    private void tell(int number, double seconds, TelemetryItem item) {
        studio.telemetry().accept(new TelemetryMessage(TEAM, number, seconds, item));
    }

    @Test
    void jointsOfTheRunningRobotAreShown() {
        browser.await("[...document.querySelectorAll('.joint-row')].some(row =>"
                + " row.textContent.includes('Knee pitch') && Math.abs(parseFloat(row.querySelector('.angle').textContent)"
                + " - studio.state.frame.robots[0].degrees[studio.state.scene.models.TYPE_0.hinges.findIndex(hinge =>"
                + " hinge.joint === 'LEFT_KNEE_PITCH')]) < 3)");
        browser.await("document.querySelector('.robot-facts').textContent.includes('stands')");
        browser.await("document.querySelectorAll('.plot').length === 4");
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void robotTellsWhatItThinks() {
        tell(1, 1.5, new TelemetryItem.LogEntry("WARNING", "the ball is <b>far</b>"));
        tell(1, 1.5, new TelemetryItem.MotionProgress("walk-forward", 3));
        tell(1, 1.6, new TelemetryItem.PlotValue("courage", 7));
        tell(
                1,
                1.6,
                new TelemetryItem.Belief(
                        List.of(new BelievedThing("ball", new Vector3(1, 0.2, -0.4), 0, true)), Optional.empty()));

        browser.await("document.querySelector('.log .warning')?.textContent.includes('<b>far</b>')");
        browser.await("document.querySelector('.robot-motion').textContent"
                + " === 'Motion walk-forward, on the way to keyframe 3'");
        browser.await("document.querySelectorAll('.map .belief.ball').length === 1");
        browser.await("document.querySelectorAll('.map .truth').length === 6");
        browser.await("[...document.querySelector('#add-curve').options].some(option => option.value === 'courage')");
    }

    @Test
    void onlyTheChosenRobotIsHeard() {
        browser.press("n");
        browser.await("studio.robot.watched.endsWith('2')");
        browser.await("document.querySelectorAll('.joint-row').length === 24");

        SmallSimulation.awaitTrue(() -> {
            tell(1, 1, new TelemetryItem.LogEntry("INFO", "one"));
            tell(2, 1, new TelemetryItem.LogEntry("INFO", "two"));
            return browser.evaluate("document.querySelector('.log').textContent.includes('two')")
                    .getAsBoolean();
        });

        assertThat(browser.evaluate("studio.robot.thoughts.size").getAsInt()).isLessThanOrEqualTo(2);
        assertThat(browser.evaluate("document.querySelector('.log').textContent")
                        .getAsString())
                .doesNotContain("one");
    }

    @Test
    void curvesAreChosenAndRoomIsWorthAPicture() throws IOException {
        browser.evaluate("(() => { const list = document.querySelector('#add-curve'); list.value = 'neck yaw';"
                + " list.dispatchEvent(new Event('change')); })()");
        browser.await("document.querySelectorAll('.plot').length === 5");
        for (int i = 0; i < 12; i++) {
            tell(1, i, new TelemetryItem.LogEntry(i % 5 == 4 ? "WARNING" : "INFO", "step " + i + " towards the ball"));
        }
        tell(1, 3, new TelemetryItem.MotionProgress("walk-forward", 3));
        tell(
                1,
                3,
                new TelemetryItem.Belief(
                        List.of(new BelievedThing("ball", new Vector3(0.9, -0.4, -0.4), 0.1, true)), Optional.empty()));
        browser.await(
                "document.querySelectorAll('.log li').length === 12 && studio.robot.traces[0].points.length > 15");
        Path pictures = Path.of(System.getProperty("studio.pictures", "target/pictures"));
        Files.write(Files.createDirectories(pictures).resolve("studio-robot.png"), browser.screenshot());

        assertThat(browser.evaluate("document.documentElement.scrollWidth").getAsInt())
                .isEqualTo(1366);
    }
}

package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.DoubleAccumulator;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.file.MotionFiles;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;

/** Follows the bold words of {@code docs/first-motion.md} literally. */
@Tag("slow")
@InBrowser
class FirstMotionTest {

    private static final Path GUIDE = Path.of("..", "..", "docs", "first-motion.md");
    private static final Pattern STEP = Pattern.compile("(?ms)^\\d\\. .*?(?=^\\d\\. |^## )");
    private static final Pattern BOLD = Pattern.compile("\\*\\*(.+?)\\*\\*");
    private static final Joint ARM = Joint.LEFT_SHOULDER_PITCH;
    private static final String STATE = "studio.motion.editor.state";
    private static final String FRAMES = STATE + ".history.present.value.lines.filter(line => line.keyframe)";

    @TempDir
    private Path project;

    private final Chromium browser;

    FirstMotionTest(Chromium browser) {
        this.browser = browser;
    }

    @Test
    void guideLeadsToAMotionOfThreeKeyframesThatAnAgentPlaysByItsName() throws Exception {
        Path folder = project.resolve("motions");
        List<String> bold = boldWordsOfTheSteps();
        assertThat(bold).containsExactly("Motion", "+ New", "+ Keyframe", "▶ Play", "Try with physics", "Save");
        try (TestSimulator simulation = new TestSimulator().withRobot();
                StudioServer studio = StudioServer.start(
                        simulation.control(), 0, AccessToken.random(), new StudioFolders(folder, Optional.empty()))) {
            browser.visit(studio.oneTimeAddress() + "&quality=lowest");
            press("Motion");
            browser.await("studio.motion && " + STATE + ".name === 'wave' && !studio.motion.stale");
            press("+ New");
            browser.await(FRAMES + ".length === 1 && !studio.motion.stale");
            dragTheArm(-70);
            for (int keyframe = 2; keyframe <= 3; keyframe++) {
                press("+ Keyframe");
                browser.await(FRAMES + ".length === " + keyframe + " && !studio.motion.stale");
                dragTheArm(keyframe == 2 ? 40 : -60);
            }
            browser.evaluate(
                    "(function look() { window.hasPlayed ||= " + STATE + ".playing; requestAnimationFrame(look); })()");
            press("▶ Play");
            browser.await("window.hasPlayed && !" + STATE + ".playing");
            press("Try with physics");
            browser.await(STATE + ".trial && !" + STATE + ".playing");
            press("Save");
            browser.fill("#answer", "my-first");
            browser.click("#accept");
            Path file = folder.resolve("my-first.txt");
            simulation.awaitTrue(() -> Files.exists(file));

            List<Keyframe> keyframes = MotionFiles.load(file).keyframes();
            assertThat(keyframes).hasSize(3);
            assertThat(keyframes.get(1).posture())
                    .isNotEqualTo(keyframes.get(0).posture())
                    .isNotEqualTo(keyframes.get(2).posture());
            assertThat(browser.complaints()).isEmpty();
            assertThat(nearestToWhenPlayed(keyframes.get(1).posture().degrees(ARM)))
                    .isLessThan(3);
        }
    }

    /** Plays the motion by name in an agent, and returns the smallest distance of the arm from an angle, in degrees. */
    private double nearestToWhenPlayed(double degrees) throws Exception {
        int hinge = NaoModel.of(RobotType.TYPE_0).hingeIndex(ARM);
        DoubleAccumulator nearest = new DoubleAccumulator(Math::min, Double.MAX_VALUE);
        SimulationObserver observer = world -> world.robots()
                .forEach(robot -> nearest.accumulate(Math.abs(robot.body().hingeDegrees()[hinge] - degrees)));
        SimulatorSettings settings = SimulatorSettings.of(
                        WorldSettings.beginner().withSeed(1))
                .withAgentPort(0)
                .withAwaitedAgents(1)
                .withSpeed(SimulationControl.AS_FAST_AS_POSSIBLE);
        try (Simulator simulator = Simulator.start(settings, Console.silent())) {
            simulator.control().addObserver(observer);
            Process agent = new ProcessBuilder(
                            ProcessHandle.current().info().command().orElse("java"),
                            "-cp",
                            System.getProperty("java.class.path"),
                            PlaysByName.class.getName(),
                            "my-first",
                            Integer.toString(simulator.agentPort()))
                    .directory(project.toFile())
                    .redirectErrorStream(true)
                    .start();
            String said = new String(agent.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            assertThat(said.lines()).contains("played");
        }
        return nearest.get();
    }

    private static List<String> boldWordsOfTheSteps() throws IOException {
        return STEP.matcher(Files.readString(GUIDE))
                .results()
                .map(MatchResult::group)
                .flatMap(step -> BOLD.matcher(step).results().map(bold -> bold.group(1)))
                .toList();
    }

    /** Clicks the button or link with this text. */
    private void press(String text) {
        browser.clickElement("[...document.querySelectorAll('button, a')].find(each => each.offsetParent"
                + " && each.textContent.trim() === " + Chromium.quoted(text) + ")");
    }

    private void dragTheArm(double up) {
        String before = browser.evaluate("JSON.stringify(studio.motion.posedNow().posture)")
                .getAsString();
        String place = "(() => { const room = studio.motion; const { posture, torso } = room.posedNow();"
                + " const poses = room.posesOf(posture, torso);"
                + " const at = 7 * room.body.model.links.findIndex(each => each.name === 'llowerarm');"
                + " return room.stage.pageAt([poses[at], poses[at + 1], poses[at + 2]]).join(' '); })()";
        String[] numbers = browser.evaluate(place).getAsString().split(" ", -1);
        double x = Double.parseDouble(numbers[0]);
        double y = Double.parseDouble(numbers[1]);
        browser.mouse("mousePressed", x, y);
        browser.mouse("mouseMoved", x + 3, y + up / 2);
        browser.mouse("mouseMoved", x + 5, y + up);
        browser.mouse("mouseReleased", x + 5, y + up);
        browser.await("JSON.stringify(studio.motion.posedNow().posture) !== " + Chromium.quoted(before));
    }
}

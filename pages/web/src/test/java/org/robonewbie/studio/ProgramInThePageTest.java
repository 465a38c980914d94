package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.robonewbie.web.KnownPrograms;

/** Programming in the static page, with javac and the bytecode interpreter. */
@InBrowser
@Timeout(300)
class ProgramInThePageTest {

    private static final String HEAD = "import org.robonewbie.agent.*;\nimport org.robonewbie.nao.Joint;\n";

    private static final String ROOM = "document.querySelector('#program-room').innerText";

    private final Chromium browser;
    private StaticServer server;

    ProgramInThePageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void open() throws IOException {
        server = new StaticServer(Path.of("target", "web").toAbsolutePath());
        browser.visit(server.address() + "#program");
        browser.await("studio.rooms.program?.files?.file !== undefined");
    }

    @AfterEach
    void end() {
        server.close();
    }

    @Test
    void firstProgramRaisesTheArmTo31Degrees() {
        browser.click("#program-run");

        browser.await("document.querySelector('#program-room').innerText.includes('left shoulder 31.2 degrees')");

        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void programRunsInAPageThatWasThereBefore() {
        browser.evaluate("navigator.serviceWorker.ready.then(() => true)");
        browser.visit(server.address() + "#program");
        browser.await("studio.rooms.program?.files?.file !== undefined");
        assertThat(browser.evaluate("navigator.serviceWorker.controller !== null")
                        .getAsBoolean())
                .isTrue();

        browser.click("#program-run");

        browser.await(ROOM + ".includes('left shoulder 31.2 degrees')");
    }

    @Test
    void mistakeStandsAtItsLineInTheWordsOfJavac() {
        type(
                HEAD
                        + "public class MyAgent extends Agent {\n    protected void think() {\n        nao.sayy(\"x\");\n    }\n}\n");

        browser.await("document.querySelector('#program-room').innerText.includes('cannot find symbol')");

        assertThat(browser.evaluate("document.querySelector('#program-remarks').innerText")
                        .getAsString())
                .contains("5");
    }

    @ParameterizedTest
    @CsvSource({
        "new Thread(() -> {}).start();, This page has no threads",
        "new org.robonewbie.exercises.Grader();, press Check",
        "new java.util.Scanner(System.in);, cannot use files or the keyboard",
        "java.time.Instant.now();, nao.getTime()",
        "nao.setJointSped(0);, Did you mean setJointSpeed?",
        "'new Vector3(1, 2, 3);', Add at the top of the file: import org.robonewbie.nao.Vector3;",
        "org.robonewbie.nao.motion.Posture.ZERO.zzz();, Posture has the methods",
        "int a = 1, Something is missing just before this point"
    })
    void diagnosticHasAHint(String statement, String advice) {
        type(HEAD + "public class MyAgent extends Agent {\n    protected void think() {\n        " + statement
                + "\n    }\n}\n");

        browser.await("document.querySelector('#program-room').innerText.includes(" + Chromium.quoted(advice) + ")");
    }

    @Test
    void programWithNaoIsSuspendedInTheMiddle() {
        type("""
                import org.robonewbie.agent.Nao;
                public class MyAgent {
                    public static void main(String[] args) {
                        try (Nao nao = Nao.connect(args)) {
                            nao.perform("wave");
                            System.out.println("waved until " + nao.getTime());
                        }
                    }
                }
                """);
        browser.click("#program-run");

        browser.await("document.querySelector('#program-room').innerText.includes('waved until')");
    }

    @Test
    void endlessLoopIsStoppedAndNamed() {
        type(HEAD + "public class MyAgent extends Agent {\n    protected void think() {\n        while (true) {\n"
                + "        }\n    }\n}\n");
        browser.click("#program-run");

        browser.await(ROOM + ".includes('Stopped at MyAgent.java:5')");
        browser.await("document.querySelector('#program-editor').shadowRoot.querySelectorAll('.cm-said').length === 1");

        type(HEAD + "public class MyAgent extends Agent {}\n");
        browser.click("#program-save");

        browser.await("!" + ROOM + ".includes('Stopped at MyAgent.java:5')");
    }

    @Test
    void stoppedLoopShowsNoCallsOfThePageItself() {
        type(HEAD + "public class MyAgent extends Agent {\n    protected void think() {\n        while (true) {\n"
                + "        }\n    }\n}\n");
        browser.click("#program-run");
        browser.await("document.querySelector('#program-room').innerText.includes('Stopped at MyAgent.java:5')");

        assertThat(browser.evaluate("document.querySelector('#program-room').innerText")
                        .getAsString())
                .doesNotContain("Fake");
    }

    static List<KnownPrograms.Text> documented() {
        return KnownPrograms.documented();
    }

    @ParameterizedTest
    @MethodSource("documented")
    void programOfReadmeOrTutorialRuns(KnownPrograms.Text program) {
        browser.fill("#speed", "fastest");
        browser.await("studio.state.frame.cycle > 3000");
        type(program.text());
        browser.click("#program-run");

        browser.await("studio.state.frame.cycle > 100 && studio.state.frame.cycle < 3000");
        assertThat(browser.evaluate("studio.rooms.program.service.state()"
                                + ".then(({ state, exitCode, output }) => `${state} ${exitCode} ${output}`)")
                        .getAsString())
                .matches("(?s)(RUNNING|ENDED) 0 .*")
                .doesNotContain("Exception", "is not available");
    }

    @Test
    void pageWithoutARobotShowsWhatToDo() {
        type("""
                public class MyAgent {
                    public static void main(String[] args) {
                        System.out.println("done");
                    }
                }
                """);
        browser.click("#program-run");
        browser.await("studio.state.scene?.robots.length === 0");
        browser.evaluate("location.hash = '#field'");

        browser.await("document.querySelector('#banner').innerText.includes('Choose an agent in the toolbar')");
    }

    @Test
    void enumerationsAndRecordsOfTheProgramWork() {
        type("""
                import org.robonewbie.agent.Agent;
                public class MyAgent extends Agent {
                    enum Mood { GLAD }
                    record Pair(int one, Mood other) {}
                    protected void think() {
                        System.out.println(new Pair(1, Mood.GLAD));
                    }
                }
                """);
        browser.click("#program-run");

        browser.await("document.querySelector('#program-room').innerText.includes('Pair[one=1, other=GLAD]')");
    }

    @Test
    void exceptionIsReportedWithItsLineAndTheRobotContinues() {
        type(HEAD + "public class MyAgent extends Agent {\n    protected void think() {\n"
                + "        int[] numbers = {1, 2};\n        log.info(\"\" + numbers[2]);\n    }\n}\n");
        browser.click("#program-run");

        browser.await("document.querySelector('#program-room').innerText.includes('MyAgent.java:6')");
        assertThat(browser.evaluate("document.querySelector('#program-state').innerText")
                        .getAsString())
                .contains("is running");
    }

    @Test
    void wrongValueIsReportedWithItsLine() {
        type(HEAD + "public class MyAgent extends Agent {\n    protected void think() {\n"
                + "        nao.setJointAngle(Joint.LEFT_KNEE_PITCH, 500);\n    }\n}\n");
        browser.click("#program-run");

        browser.await(ROOM + ".includes('it is limited to the range. (MyAgent.java:5)')");
    }

    @Test
    void savingSwapsTheProgramAndKeepsTheWorld() {
        browser.click("#program-run");
        browser.await(ROOM + ".includes('left shoulder 31.2 degrees')");
        browser.await("studio.state.frame.cycle > 300");
        browser.click("#toggle");
        browser.await("studio.state.frame.paused");
        String ball =
                browser.evaluate("JSON.stringify(studio.state.frame.ball)").getAsString();
        browser.click("#toggle");
        String text = browser.evaluate("studio.rooms.program.editor.text").getAsString();
        type(text.replace("angle < 30", "angle < 60"));

        browser.evaluate("studio.rooms.program.save()");

        browser.await(ROOM + ".includes('left shoulder 61.2 degrees')");
        assertThat(browser.evaluate("studio.state.frame.cycle > 300").getAsBoolean())
                .isTrue();
        assertThat(browser.evaluate("JSON.stringify(studio.state.frame.ball)").getAsString())
                .isEqualTo(ball);
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void sliderChangesTheRunningRobotAndKeepsItsState() {
        type("""
                import org.robonewbie.agent.Agent;
                import org.robonewbie.nao.Joint;
                public class MyAgent extends Agent {
                    private final double raised = number("raised", 30, 0, 90);
                    private final Speed speed = new Speed(number("gain", 4, 1, 10));
                    private int cycles;
                    private record Speed(double gain) {}
                    protected void think() {
                        double angle = nao.getJointAngle(Joint.LEFT_SHOULDER_PITCH);
                        nao.setJointSpeed(Joint.LEFT_SHOULDER_PITCH, speed.gain() * (raised - angle));
                        nao.plot("arm", Math.rint(angle));
                        nao.plot("gain", speed.gain());
                        nao.plot("cycles", ++cycles);
                    }
                }
                """);
        browser.click("#program-run");
        browser.await("document.querySelector('#program-values').innerText.includes('arm 30')");

        browser.fill("#program-sliders input[aria-label=raised]", "60");
        browser.fill("#program-sliders input[aria-label=gain]", "2");

        browser.await("document.querySelector('#program-values').innerText.includes('arm 60')");
        browser.await("document.querySelector('#program-values').innerText.includes('gain 2')");
        assertThat(browser.evaluate(
                                "Number(document.querySelector('#program-values').innerText.match(/cycles (\\d+)/)[1])"
                                        + " > 50")
                        .getAsBoolean())
                .isTrue();
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void programWithMistakesLeavesTheOneBeforeInItsPlace() {
        browser.click("#program-run");
        browser.await(ROOM + ".includes('left shoulder 31.2 degrees')");
        type(HEAD + "public class MyAgent extends Agent {");

        browser.evaluate("studio.rooms.program.save()");

        browser.await("document.querySelector('#program-remarks').innerText.includes('reached end of file')");
        assertThat(browser.evaluate("studio.rooms.program.service.state().then(({ state }) => state)")
                        .getAsString())
                .isEqualTo("RUNNING");
    }

    @Test
    void programPlaysBesideAShippedAgent() {
        browser.fill("#page-more", "Agent_SimpleSoccer");
        browser.await("studio.state.scene.robots.length === 2");

        browser.click("#program-run");

        browser.await(ROOM + ".includes('left shoulder 31.2 degrees')");
        browser.await("studio.state.scene.robots.map(({ team }) => team).sort().join() === 'Guests,RoboNewbie'");
    }

    @ParameterizedTest
    @CsvSource({
        "nao.setJoint, setJointSpeed, Sets the speed of a joint.",
        "nao.setJoint, setJointSpeed, double degreesPerSecond",
        "fieldView.ball().is, isVisible, in the last picture",
        "this.raise, raiseArm, Raises the arm.",
        "motions.sta, start, Starts a motion"
    })
    void editorProposesMembersWithTheirDocumentation(String begun, String member, String documentation) {
        String before = HEAD + "public class MyAgent extends Agent {\n    /** Raises the arm. */\n"
                + "    void raiseArm() {}\n    protected void think() {\n        " + begun;
        type(before + "\n    }\n}\n");

        String proposal = browser.evaluate("studio.rooms.program.service.complete('MyAgent.java',"
                        + " studio.rooms.program.editor.text, " + before.length() + ").then((all) =>"
                        + " JSON.stringify(all.find(({ label }) => label === '" + member + "') ?? all))")
                .getAsString();

        assertThat(proposal).contains("\"label\":\"" + member + "\"").contains(documentation);
    }

    @Test
    void proposalIsChosenWithTheMouse() {
        String before =
                HEAD + "public class MyAgent extends Agent {\n    protected void think() {\n        nao.setJointSp";
        type(before + "\n    }\n}\n");
        browser.evaluate("(({ view }) => { view.focus(); view.dispatch({ changes: { from: " + before.length()
                + ", insert: 'e' }, selection: { anchor: " + (before.length() + 1)
                + " }, userEvent: 'input.type' }); })(studio.rooms.program.editor)");
        String proposal = "studio.rooms.program.editor.view.dom.querySelector('.cm-tooltip-autocomplete li')";
        browser.await(proposal + " !== null");

        browser.evaluate(proposal + ".dispatchEvent(new MouseEvent('mousedown', { bubbles: true }))");

        browser.await("studio.rooms.program.editor.text.includes('nao.setJointSpeed()')");
    }

    private void type(String text) {
        browser.evaluate("studio.rooms.program.editor.replace(" + Chromium.quoted(text) + ")");
    }
}

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
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;

/** A student writes a program beside the robot, runs it, changes it, makes mistakes, and solves an exercise. */
@InBrowser
@Timeout(300)
class ProgramPageTest {

    private static final int HINGE = NaoModel.of(RobotType.TYPE_0).hingeIndex(Joint.LEFT_SHOULDER_PITCH);

    private static final String RAISE = """
            import org.robonewbie.agent.Agent;
            import org.robonewbie.nao.Joint;

            public class MyAgent extends Agent {
                public static void main(String[] args) {
                    new MyAgent().run(args);
                }

                @Override
                protected void think() {
                    double angle = nao.getJointAngle(Joint.LEFT_SHOULDER_PITCH);
                    nao.setJointSpeed(Joint.LEFT_SHOULDER_PITCH, 4 * (DEGREES - angle));
                }
            }
            """;

    private static final String MISTAKES = "document.querySelectorAll('#program-mistakes li').length";
    private static final String BUBBLES =
            "document.querySelector('#program-editor').shadowRoot.querySelectorAll('.cm-said').length";

    @TempDir
    private Path folder;

    private final Chromium browser;
    private ProgrammingStudio studio;

    ProgramPageTest(Chromium browser) {
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

    private void visit() {
        browser.visit(studio.address() + "&theme=light&quality=lowest#program");
        browser.await("studio.rooms.program?.files?.file !== undefined");
    }

    private void write(String program) {
        browser.evaluate("studio.rooms.program.editor.replace(" + Chromium.quoted(program) + ")");
    }

    private void awaitAngle(int degrees) {
        browser.await("Math.abs((studio.state.frame?.robots[0]?.degrees[" + HINGE + "] ?? 999) - " + degrees + ") < 2");
    }

    private String output() {
        return browser.evaluate("document.querySelector('#program-said').innerText")
                .getAsString();
    }

    private void awaitState(String text) {
        browser.await("document.querySelector('#program-state').innerText.includes(" + Chromium.quoted(text) + ")");
    }

    @Test
    void firstProgramMovesTheArmAfterOneClick() {
        visit();

        browser.click("#program-run");

        awaitState("MyAgent.java is running.");
        awaitAngle(31);
        assertThat(folder.resolve("MyAgent.java")).content().contains("public class MyAgent extends Agent");
        browser.click("#program-stop");
        awaitState("MyAgent.java was stopped.");
        assertThat(browser.complaints()).isEmpty();
    }

    @Tag("slow")
    @Test
    void programBesideItsRobotIsWorthAPicture() throws IOException {
        browser.drawSharply();
        for (String theme : new String[] {"light", "dark"}) {
            browser.resize(1366, 768);
            browser.visit(studio.address() + "&quality=high&theme=" + theme + "#program");
            browser.await("studio.rooms.program?.files?.file !== undefined");
            write(RAISE.replace("DEGREES", "60").replace("double angle", "nao.plot(\"x\", 3);\n        double angle"));
            if (theme.equals("light")) {
                browser.click("#program-run");
            }
            awaitAngle(60);
            picture("program-" + theme);
            write(RAISE.replace("DEGREES", "degres"));
            awaitState("1 error");
            browser.resize(1024, 768);
            picture("program-mistake-" + theme);
        }
    }

    private void picture(String name) throws IOException {
        Picture.keep(name + ".png", browser.screenshot());
    }

    @Tag("slow")
    @Test
    void mistakeIsShownBelowItsLineWithWhatToDo() {
        visit();

        write(RAISE.replace("DEGREES", "degres"));

        awaitState("1 error, line 12");
        browser.await(inEditor(".cm-said") + "?.innerText.includes('cannot find symbol')");
        write(RAISE.replace("DEGREES", "45"));
        browser.await(inEditor(".cm-said") + " === null");
        assertThat(browser.complaints()).isEmpty();
    }

    @Tag("slow")
    @Test
    void programIsChangedWhileItRunsAndTheWorldGoesOn() throws IOException {
        visit();
        write(RAISE.replace("DEGREES", "45"));
        browser.click("#program-run");
        awaitAngle(45);
        double before = browser.evaluate("studio.state.frame.gameTime").getAsDouble();

        write(RAISE.replace("DEGREES", "-20"));
        browser.click("#program-save");

        awaitAngle(-20);
        assertThat(browser.evaluate("studio.state.frame.gameTime").getAsDouble())
                .isGreaterThan(before);
        assertThat(Files.readString(folder.resolve("MyAgent.java"))).contains("-20");
        assertThat(browser.complaints()).isEmpty();
    }

    @Tag("slow")
    @Test
    void sliderActsOnTheRunningRobotAndIsWrittenIntoTheProgram() throws IOException {
        visit();
        write(RAISE.replace("DEGREES", "raised")
                .replace(
                        "    @Override",
                        "    private final double raised = number(\"raised\", 30, 0, 90);\n\n    @Override"));
        browser.click("#program-run");
        browser.await("document.querySelector('.program-slider input') !== null");
        awaitAngle(30);
        String program = browser.evaluate("studio.rooms.program.runs.now.id").getAsString();

        browser.fill("#program-sliders input", "60");

        awaitAngle(60);
        assertThat(browser.evaluate("studio.rooms.program.runs.now.id").getAsString())
                .isEqualTo(program);
        browser.evaluate("document.querySelector('.program-slider button:last-child').click()");
        browser.await("studio.rooms.program.editor.text.includes('number(\"raised\", 60, 0, 90)')");
        browser.evaluate("studio.rooms.program.save()");
        browser.await("studio.rooms.program.runs.now.id > " + program
                + " && document.querySelector('#program-sliders output')?.innerText === '60'");
        awaitAngle(60);
        assertThat(folder.resolve("MyAgent.java")).content().contains("number(\"raised\", 60, 0, 90)");
        assertThat(browser.complaints()).isEmpty();
    }

    @Tag("slow")
    @Test
    void endlessLoopEndsAndItsLineIsNamed() {
        visit();
        write(RAISE.replace(
                "4 * (DEGREES - angle));", "0);\n        while (angle < 1e9) {\n            angle += 0;\n        }"));

        browser.click("#program-run");

        awaitState("think() did not return (MyAgent.java:1");
        assertThat(browser.evaluate("[" + MISTAKES + ", " + BUBBLES + "].join()")
                        .getAsString())
                .isEqualTo("1,1");
        write(RAISE.replace("DEGREES", "45"));
        browser.click("#program-save");

        awaitState("No program is running");
        assertThat(browser.evaluate("[" + MISTAKES + ", " + BUBBLES + "].join()")
                        .getAsString())
                .isEqualTo("0,0");
        assertThat(output()).doesNotContain("has not returned");
        assertThat(browser.complaints()).isEmpty();
    }

    @Tag("slow")
    @Test
    void failureOfTheRunningProgramIsShownAtItsLineAndValuesBesideTheirs() {
        visit();
        write(RAISE.replace(
                "4 * (DEGREES - angle));",
                "0);\n        nao.plot(\"angle\", 7);\n        int oh = 1 / (int) (angle * 0);"));

        browser.click("#program-run");

        browser.await("document.querySelector('#program-mistakes').innerText.includes('Line 14')");
        browser.await(inEditor(".cm-failed") + "?.innerText.includes('int oh')");
        browser.await(inEditor(".cm-value") + "?.innerText === '= 7'");
        browser.click("#program-stop");
        assertThat(browser.complaints()).isEmpty();
    }

    @Tag("slow")
    @Test
    void exceptionIsShownOnceAndIsGoneWhenItIsFixed() {
        visit();
        write(RAISE.replace("4 * (DEGREES - angle));", "1 / (int) (angle * 0));"));
        browser.click("#program-run");

        browser.await(MISTAKES + " === 1 && " + BUBBLES + " === 1");
        awaitState("is running");
        assertThat(output().split("think\\(\\) failed", -1)).hasSize(2);
        assertThat(output()).doesNotContain("Called from");
        browser.evaluate("location.hash = '#robot'");
        browser.await("studio.robot !== undefined");
        browser.evaluate("location.hash = '#program'");
        write(RAISE.replace("DEGREES", "45"));
        browser.click("#program-save");

        awaitAngle(45);
        browser.await(MISTAKES + " === 0 && " + BUBBLES + " === 0");
        assertThat(output()).doesNotContain("failed");
        assertThat(browser.evaluate("document.querySelector('#diagnostics').hidden")
                        .getAsBoolean())
                .isTrue();
        assertThat(browser.evaluate("document.querySelector('#toast').innerText")
                        .getAsString())
                .isEmpty();
        assertThat(browser.complaints()).isEmpty();
    }

    @Tag("slow")
    @Test
    void longLinesAreWrapped() {
        for (int width : new int[] {1366, 1024}) {
            browser.resize(width, 768);
            visit();
            write(RAISE.replace("DEGREES", "45").replace("angle));", "angle)); // degrees per second, at most 351"));

            browser.await(inEditor(".cm-content") + "?.innerText.includes('at most 351')");
            assertThat(browser.evaluate(inEditor(".cm-scroller") + ".scrollWidth <= " + inEditor(".cm-scroller")
                                    + ".clientWidth")
                            .getAsBoolean())
                    .isTrue();
        }
    }

    @Tag("slow")
    @Test
    void lineNumbersStayBesideTheirLinesWhenTheEditorBecomesNarrower() {
        visit();

        browser.evaluate("studio.rooms.program.editor.replace("
                + Chromium.quoted(RAISE.replace("DEGREES", "45"))
                + "); studio.rooms.program.editor.view.measure();"
                + " document.querySelector('#program-editor').style.marginRight = '300px'");

        String tops = ".map(each => each.getBoundingClientRect().top).join()";
        browser.await(inEditor(".cm-content") + ".scrollHeight > 21 * " + inEditor(".cm-content") + ".children.length");
        browser.await("[...document.querySelector('#program-editor').shadowRoot"
                + ".querySelectorAll('.cm-lineNumbers .cm-gutterElement')].filter(each => each.offsetHeight > 0)" + tops
                + " === [..." + inEditor(".cm-content") + ".children]" + tops);
    }

    @Tag("slow")
    @Test
    void firstExerciseIsSolvedAndChecked() {
        visit();
        browser.evaluate("document.querySelector('#program-file').value = 'exercise raise-arms'");
        browser.evaluate("document.querySelector('#program-file').dispatchEvent(new Event('change'))");
        browser.await("document.querySelector('#program-check') !== null");
        write("""
                import org.robonewbie.agent.Agent;
                import org.robonewbie.nao.Joint;

                public class RaiseArms extends Agent {
                    @Override
                    protected void think() {
                        hold(Joint.LEFT_SHOULDER_PITCH, 60);
                        hold(Joint.RIGHT_SHOULDER_PITCH, 45);
                    }

                    private void hold(Joint joint, double degrees) {
                        nao.setJointSpeed(joint, 4 * (degrees - nao.getJointAngle(joint)));
                    }
                }
                """);

        browser.click("#program-check");

        browser.await("document.querySelector('#program-progress').innerText === 'Passed: 10.0 of 10 points'");
        browser.click("#program-leave");
        browser.await("document.querySelector('#program-verdict > div').hidden");
        assertThat(browser.complaints()).isEmpty();
    }

    @Tag("slow")
    @Test
    void panelOfExercisesLeadsToTheProgramBesideTheRobot() {
        browser.visit(studio.address() + "&theme=light&quality=lowest#field/exercises");
        browser.await("document.querySelector('[data-exercise=raise-arms]')");
        browser.click("[data-exercise=raise-arms]");
        browser.await("document.querySelector('#course-here').checkVisibility()");

        browser.click("#course-here");

        browser.await("document.querySelector('#program-check') !== null");
        browser.await("studio.rooms.program.files.file.path === 'RaiseArms.java' && location.hash === '#program'");
        browser.await("studio.rooms.program.editor.text.includes('class RaiseArms')");
        assertThat(browser.complaints()).isEmpty();
    }

    @Tag("slow")
    @Test
    void stepLetsTheWorldGoOnByOneCycle() {
        visit();
        write(RAISE.replace("DEGREES", "45"));
        browser.click("#program-run");
        awaitAngle(45);
        browser.click("#program-step");
        browser.await("studio.state.frame.paused");
        int before = browser.evaluate("studio.state.frame.cycle").getAsInt();

        browser.click("#program-step");

        browser.await("studio.state.frame.paused && studio.state.frame.cycle > " + before);
        assertThat(browser.evaluate("studio.state.frame.cycle").getAsInt()).isEqualTo(before + 1);
    }

    @Tag("slow")
    @Test
    void whatIsNotSavedIsThereAfterTheBrowserHasEnded() throws IOException {
        Files.writeString(folder.resolve("MyAgent.java"), RAISE.replace("DEGREES", "45"));
        visit();
        write(RAISE.replace("DEGREES", "50"));
        browser.await("!studio.rooms.program.isAtRisk");

        visit();

        browser.await("studio.rooms.program.editor.text.includes('(50 - angle)')");
        assertThat(folder.resolve("MyAgent.java")).content().contains("(45 - angle)");
    }

    @Tag("slow")
    @Test
    void whatAnotherProgramWritesAppears() throws IOException {
        Files.writeString(folder.resolve("MyAgent.java"), RAISE.replace("DEGREES", "45"));
        visit();

        Files.writeString(folder.resolve("MyAgent.java"), RAISE.replace("DEGREES", "-30"));

        browser.await("studio.rooms.program.editor.text.includes('(-30 - angle)')");
    }

    private static String inEditor(String selector) {
        return "document.querySelector('#program-editor').shadowRoot.querySelector('" + selector + "')";
    }
}

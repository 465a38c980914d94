package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.app.studio.StudioProcess;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;

/** The studio that {@code run} opens has all rooms, shows the program that runs, and takes it over on the first save. */
@InBrowser
@Tag("slow")
@Timeout(300)
class RunPageTest {

    private static final int HINGE = NaoModel.of(RobotType.TYPE_0).hingeIndex(Joint.LEFT_SHOULDER_PITCH);
    private static final String STATE = "document.querySelector('#program-state').innerText";

    @TempDir
    private Path folder;

    private final Chromium browser;

    private Optional<StudioProcess> studio = Optional.empty();

    RunPageTest(Chromium browser) {
        this.browser = browser;
    }

    @AfterEach
    void close() {
        studio.ifPresent(StudioProcess::close);
    }

    private void run(String program, String... options) throws IOException {
        List<String> command = List.of("run", program, "--no-browser", "--seed", "1");
        StudioProcess started = StudioProcess.start(
                folder, Stream.concat(command.stream(), Stream.of(options)).toArray(String[]::new));
        studio = Optional.of(started);
        browser.visit(started.oneTimeAddress() + "&theme=light&quality=lowest#program");
        browser.await("studio.rooms.program?.files?.file !== undefined && studio.state.frame?.robots.length > 0");
    }

    private void replace(String before, String after) {
        browser.evaluate("studio.rooms.program.editor.replace(studio.rooms.program.editor.text.replace("
                + Chromium.quoted(before) + ", " + Chromium.quoted(after) + "))");
        browser.click("#program-save");
    }

    private void awaitAngle(int degrees) {
        browser.await("Math.abs((studio.state.frame?.robots[0]?.degrees[" + HINGE + "] ?? 999) - " + degrees + ") < 2");
    }

    @Test
    void savingReplacesTheProgramOfTheProcess() throws IOException {
        Files.writeString(folder.resolve("MyRobot.java"), """
                import org.robonewbie.agent.Agent;
                import org.robonewbie.nao.Joint;

                public class MyRobot extends Agent {
                    public static void main(String[] args) {
                        new MyRobot().run(args);
                    }

                    @Override
                    protected void think() {
                        double angle = nao.getJointAngle(Joint.LEFT_SHOULDER_PITCH);
                        nao.setJointSpeed(Joint.LEFT_SHOULDER_PITCH, 4 * (30 - angle));
                    }
                }
                """);

        run("MyRobot.java", "--team", "Blue", "--number", "7");
        browser.await(STATE + " === 'MyRobot.java is running.'");
        awaitAngle(30);
        replace("(30 - angle)", "(70 - angle)");
        awaitAngle(70);

        browser.await(STATE + " === 'MyRobot.java is running.'");
        assertThat(browser.evaluate("studio.state.scene.robots.map(each => each.team + each.number).join()")
                        .getAsString())
                .isEqualTo("Blue7");
        assertThat(folder.resolve("MyRobot.java")).content().contains("(70 - angle)");
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void exampleBecomesAProgramOfTheUserWhenItIsSaved() throws IOException {
        run("Agent_BasicStructure");
        browser.await(STATE + " === 'Agent_BasicStructure is running; saving makes your copy MyBasicStructure.java.'");
        browser.await("[...document.querySelectorAll('#rooms a')].filter(each => each.checkVisibility())"
                + ".map(each => each.textContent).join() === 'Field,Program,Robot,Motion,Replay,Exercises'");
        assertThat(folder.resolve("MyBasicStructure.java")).doesNotExist();

        replace("class MyBasicStructure", "class  MyBasicStructure");

        browser.await(
                "studio.rooms.program.runs.now.id === 1 && " + STATE + " === 'MyBasicStructure.java is running.'");
        assertThat(folder.resolve("MyBasicStructure.java")).content().contains("class  MyBasicStructure extends");
    }
}

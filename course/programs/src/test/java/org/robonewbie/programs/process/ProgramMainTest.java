package org.robonewbie.programs.process;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.programs.ClassPath;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;

/** What the process of a program answers to its parent. */
@Timeout(120)
class ProgramMainTest {

    private static final double SECONDS = 60;

    @TempDir
    private Path folder;

    private final BlockingQueue<String> answers = new LinkedBlockingQueue<>();

    @Tag("slow")
    @Test
    void compilerAnswersWithThePrograms() throws IOException {
        Files.writeString(folder.resolve("Hello.java"), "class Hello { public static void main(String[] args) {} }");
        Path classes = folder.resolve("classes");

        try (ChildProcess process = start(ProgramMain.COMPILE, folder.toString(), "false", classes.toString())) {
            process.awaitEnd(SECONDS);

            assertThat(process.exitCode()).hasValue(0);
        }
        assertThat(answers).containsExactly("Hello", "");
        assertThat(classes.resolve("Hello.class")).exists();
    }

    @Tag("slow")
    @Test
    void mistakesAreExitCodeOne() throws IOException {
        Files.writeString(folder.resolve("Hello.java"), "class Hello { int number = true; }");

        try (ChildProcess process = start(ProgramMain.COMPILE, folder.toString(), "false", folder.toString())) {
            process.awaitEnd(SECONDS);

            assertThat(process.exitCode()).hasValue(1);
        }
    }

    /** The program plays for some cycles, in which one step fails, and ends its process. */
    @Test
    void hostPlaysRobotsAndAnswersWhyTheyLeave() throws Exception {
        Files.writeString(folder.resolve("Exits.java"), """
                public class Exits extends org.robonewbie.agent.Agent {
                    private int cycles;

                    @Override
                    protected void think() {
                        if (++cycles == 100) {
                            throw new IllegalStateException("one step");
                        } else if (nao.getTeam().equals("Last")) {
                            System.exit(7);
                        }
                    }
                }
                """);

        try (GuestDoor door = GuestDoor.open(0);
                ChildProcess process = start(ProgramMain.ROBOTS, "Exits.java", new ClassPath(List.of()).text())) {
            String ready = answers.take();
            play(door, process, 1, "First");
            String departure = answers.take();
            assertThatThrownBy(() -> play(door, process, 2, "Last")).isInstanceOf(AbsentProgramException.class);
            process.awaitEnd(SECONDS);

            assertThat(ready).isEqualTo(RobotHost.READY);
            assertThat(departure).isEqualTo("1 " + new Departure(Departure.Cause.FAILED_STEP, "", "").line());
            assertThat(process.exitCode()).hasValue(7);
        }
    }

    private static void play(GuestDoor door, ChildProcess process, int id, String team) {
        process.call(new RobotHost.Call(id, String.valueOf(door.port()), team, 1, TeamSide.LEFT).line());
        Controller robot = door.await(process::isRunning);
        try (Trial trial = Trial.served(Scene.of(RobotStart.at(-1, 0)), 1, robot)) {
            trial.run(2);
        }
    }

    private ChildProcess start(String... words) throws IOException {
        return TestProcess.start(folder, ProgramOutput.of(line -> {}, answers::add), Limits.UNTIMED, List.of(words));
    }
}

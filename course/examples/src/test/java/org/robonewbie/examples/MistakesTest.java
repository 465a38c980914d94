package org.robonewbie.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.file.MotionFiles;
import org.robonewbie.nao.motion.file.ShippedMotions;
import student.DivideByZero;
import student.EndlessLoop;
import student.MissingMotion;
import student.Patient;

/** Messages and exit codes of programs that fail. */
class MistakesTest {

    @TempDir
    private Path folder;

    @Test
    void anExceptionInThinkIsReportedOnceAndTheRobotGoesOnToTheEndWithExitCode1() throws Exception {
        try (ChildProgram program = run(DivideByZero.class, "--headless", "--seed", "1", "--fast", "--seconds", "2")) {
            int exitCode = program.exitCode();

            assertThat(exitCode).isEqualTo(1);
            assertThat(program.lines())
                    .filteredOn(line -> line.contains("the robot continues"))
                    .singleElement()
                    .asString()
                    .endsWith(
                            "think() failed with java.lang.ArithmeticException: / by zero; the robot continues with the"
                                    + " next step. (DivideByZero.java:23)");
            assertThat(program.lines()).anyMatch(line -> line.contains("cycle at 1.98"));
        }
    }

    @Tag("slow")
    @Test
    void anEndlessLoopInThinkEndsAHeadlessRunWithItsLineItsLogAndExitCode1() throws Exception {
        try (ChildProgram program = run(EndlessLoop.class, "--headless", "--seed", "1", "--fast")) {
            int exitCode = program.exitCode();

            assertThat(exitCode).isEqualTo(1);
            assertThat(program.lines())
                    .anyMatch(
                            line -> line.contains("think() has not returned for 1 s; the robot waits for it. Is this an"
                                    + " infinite loop, or is the program waiting for something? (EndlessLoop.java:2"))
                    .anyMatch(line -> line.contains("think() has not returned for 5 s; the run ends here."))
                    .anyMatch(line -> line.contains("I think"));
        }
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            Agent_BasicStructure | --host 127.0.0.1 --port 9 | No simulator answers at 127.0.0.1:9. Start one with \
            "robonewbie simulator", or omit the host to start one automatically.
            Agent_SoccerTeam     | 12 --headless             | A team has 1 to 11 players, not "12".
            Agent_Wave           | --headles                 | The option "headles" on the command line is unknown. \
            Did you mean --headless?
            """)
    void wrongArgumentsEndWithOneSentenceAndExitCode2(String program, String args, String sentence) throws Exception {
        Class<?> main = Class.forName("org.robonewbie.examples." + program);

        try (ChildProgram child = run(main, args.split(" "))) {
            int exitCode = child.exitCode();

            assertThat(exitCode).isEqualTo(2);
            assertThat(child.lines()).containsExactly(sentence);
        }
    }

    @Tag("slow")
    @Test
    void theLogIsPrintedWhenTheProgramIsInterrupted() throws Exception {
        try (ChildProgram program = run(Patient.class, "--headless", "--seed", "1")) {
            assumeThat(program.canBeInterrupted()).isTrue();
            program.awaitLine("thinking");

            program.interrupt();
            program.exitCode();

            assertThat(program.lines()).anyMatch(line -> line.contains("I am here"));
        }
    }

    @Tag("slow")
    @Test
    void aMissingMotionIsReportedOnceAndTheRunEndsWithExitCode1() throws Exception {
        try (ChildProgram program = run(MissingMotion.class, "--headless", "--seed", "1", "--fast", "--seconds", "2")) {
            int exitCode = program.exitCode();

            assertThat(exitCode).isEqualTo(1);
            assertThat(program.lines())
                    .filteredOn(line -> line.contains("wawe"))
                    .singleElement()
                    .asString()
                    .contains("wave")
                    .contains("(MissingMotion.java:");
        }
    }

    @Test
    void aBrokenMotionFileIsReportedWithItsLineAndTheRobotGoesOn() throws Exception {
        Files.createDirectories(folder.resolve("motions"));
        Files.writeString(folder.resolve("motions/my-motion.txt"), "// mine\n500 1 2 three\n");

        try (ChildProgram program =
                run(Agent_KeyframeDeveloper.class, "--headless", "--seed", "1", "--fast", "--seconds", "10")) {
            int exitCode = program.exitCode();

            assertThat(exitCode).isEqualTo(1);
            assertThat(program.lines())
                    .filteredOn(line -> line.contains("my-motion"))
                    .singleElement()
                    .asString()
                    .contains("The motion my-motion cannot be played: my-motion.txt line 2")
                    .contains("three")
                    .contains("(Agent_KeyframeDeveloper.java:");
        }
    }

    @Tag("slow")
    @Test
    void keyframeDeveloperBeginsANewFileAndSaysWhereItIs() throws Exception {
        try (ChildProgram program = run(
                Agent_KeyframeDeveloper.class, "hop.txt", "--headless", "--seed", "1", "--fast", "--seconds", "1")) {
            int exitCode = program.exitCode();

            assertThat(exitCode).isZero();
            assertThat(folder.resolve("motions/hop.txt")).exists();
            assertThat(program.lines()).anyMatch(line -> line.contains("hop.txt and save it"));
        }
    }

    @Tag("slow")
    @Test
    void keyframeDeveloperPlaysWhatIsSavedWhileItRunsAlsoAfterAMistake() throws Exception {
        try (ChildProgram program = run(
                Agent_KeyframeDeveloper.class,
                "--headless",
                "--seed",
                "1",
                "--fast",
                "--seconds",
                "600",
                "--report",
                "report.json")) {
            program.awaitLine("and save it");
            Files.writeString(folder.resolve("motions/my-motion.txt"), "oops\n");
            program.awaitLine("cannot be played: my-motion.txt line 1");
            MotionFiles.save(ShippedMotions.file("fall-back"), folder.resolve("motions/my-motion.txt"));
            int exitCode = program.exitCode();

            assertThat(exitCode).isZero();
            assertThat(Files.readString(folder.resolve("report.json"))).containsPattern("\"falls\": [1-9]");
        }
    }

    @Test
    void keyframeDeveloperGetsUpByItselfAndTriesAgain() throws Exception {
        Files.createDirectories(folder.resolve("motions"));
        MotionFile fall = ShippedMotions.file("fall-back");
        MotionFiles.save(fall, folder.resolve("motions/my-motion.txt"));

        try (ChildProgram program = run(
                Agent_KeyframeDeveloper.class,
                "--headless",
                "--seed",
                "1",
                "--fast",
                "--seconds",
                "30",
                "--report",
                "report.json")) {
            int exitCode = program.exitCode();

            assertThat(exitCode).isZero();
            assertThat(Files.readString(folder.resolve("report.json"))).containsPattern("\"falls\": ([2-9])");
        }
    }

    private ChildProgram run(Class<?> program, String... args) throws Exception {
        return new ChildProgram(folder, program, args);
    }
}

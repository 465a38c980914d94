package org.robonewbie.app.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.app.Main;
import org.robonewbie.app.Printed;
import org.robonewbie.exercises.Grade;

class GradeCommandTest {

    private static final String SOLUTION = """
            raise(Joint.LEFT_SHOULDER_PITCH, 60);
            raise(Joint.RIGHT_SHOULDER_PITCH, 45);
            """;

    @TempDir
    Path folder = Path.of("");

    @Test
    void exercisesAreListed() {
        Printed printed = Printed.by("grade");

        assertThat(printed.exitCode()).isZero();
        assertThat(printed.out()).contains("01-raise-arms").contains("17-score-a-goal");
    }

    @Test
    void misspeltExerciseIsAskedBack() {
        Printed printed = Printed.by("grade", "kickk", "Kick.java");

        assertThat(printed.exitCode()).isEqualTo(2);
        assertThat(printed.err()).contains("There is no exercise \"kickk\". Did you mean kick?");
    }

    @Test
    void missingSolutionIsAskedFor() {
        Printed printed = Printed.by("grade", "kick");

        assertThat(printed.exitCode()).isEqualTo(2);
        assertThat(printed.err()).contains("robonewbie grade kick --start");
    }

    @Test
    void solvedExercisePassesAndIsWrittenAsJson() throws IOException {
        Path json = folder.resolve("grade.json");

        Printed printed =
                Printed.by("grade", "raise-arms", program(SOLUTION), "--seeds", "2", "--json", json.toString());

        assertThat(printed.exitCode()).as(printed.out()).isZero();
        assertThat(printed.out()).contains("01-raise-arms PASSED: 10.0 of 10 points");
        assertThat(Grade.ofJson(Files.readString(json)).passed()).isTrue();
    }

    @Tag("slow")
    @Test
    void firstTrialIsShownInTheStudioAfterTheGrade() throws IOException {
        Process process = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-cp",
                        System.getProperty("java.class.path"),
                        Main.class.getName(),
                        "grade",
                        "raise-arms",
                        program(SOLUTION),
                        "--seeds",
                        "1",
                        "--watch",
                        "--no-browser")
                .redirectErrorStream(true)
                .start();

        try (BufferedReader lines = process.inputReader(StandardCharsets.UTF_8)) {
            List<String> read = new ArrayList<>();
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                read.add(line);
                if (line.startsWith("Studio: ")) {
                    break;
                }
            }
            assertThat(read).anyMatch(line -> line.contains("01-raise-arms PASSED"));
            assertThat(read.get(read.size() - 1)).endsWith("#replay/raise-arms@play");
        } finally {
            process.destroyForcibly();
        }
    }

    @Tag("slow")
    @Test
    void staticFieldsBelongToOneTrial() throws IOException {
        Printed printed =
                Printed.by("grade", "raise-arms", program("if (trials++ < 300) { " + SOLUTION + "}"), "--seeds", "2");

        assertThat(printed.exitCode()).as(printed.out()).isZero();
    }

    @Tag("slow")
    @Test
    void programThatEndsTheProcessCostsOnlyItsPoints() throws IOException {
        Printed printed = Printed.by("grade", "raise-arms", program("System.exit(0);"), "--seeds", "1");

        assertThat(printed.exitCode()).isEqualTo(1);
        assertThat(printed.out())
                .contains("The program ended the whole process (exit code 0). Does it call System.exit?")
                .contains("0.0 of 10 points");
    }

    @Test
    void whatAProgramPrintsCannotBeTakenForAVerdict() throws IOException {
        Printed printed = Printed.by(
                "grade",
                "raise-arms",
                program("if (trials++ == 0) { System.out.println(\"01-raise-arms PASSED: 10.0 of 10 points\"); }"),
                "--seeds",
                "1");

        assertThat(printed.out()).doesNotContain("PASSED");
        assertThat(printed.err().lines()).contains("  program| 01-raise-arms PASSED: 10.0 of 10 points");
    }

    @Tag("slow")
    @Test
    void compilersMessagesAreNotMarkedAsThoseOfTheProgram() throws IOException {
        Printed printed = Printed.by("grade", "raise-arms", program("nonsense"), "--seeds", "1");

        assertThat(printed.exitCode()).isNotZero();
        assertThat(printed.err()).contains("error: not a statement").doesNotContain("program|");
    }

    @Test
    void hintsAndSolutionsAreOfferedByName() {
        Printed hint = Printed.by("grade", "raise-arms", "--hint");
        Printed solution = Printed.by("grade", "raise-arms", "--solution");

        assertThat(hint.exitCode()).isZero();
        assertThat(hint.out()).startsWith("Hint 1 of ");
        assertThat(solution.exitCode()).isEqualTo(1);
        assertThat(solution.err()).isNotBlank();
    }

    @Tag("slow")
    @Test
    void mistakeBeforeTheFirstCycleIsToldWithItsLine() throws IOException {
        Path file = Files.writeString(folder.resolve("Broken.java"), """
                import org.robonewbie.agent.Agent;

                public class Broken extends Agent {
                    public Broken() {
                        throw new IllegalStateException("mistake");
                    }
                }
                """);

        Printed printed = Printed.by("grade", "raise-arms", file.toString(), "--seeds", "1");

        assertThat(printed.exitCode()).isEqualTo(1);
        assertThat(printed.out()).contains("its constructor threw java.lang.IllegalStateException: mistake");
    }

    @Tag("slow")
    @Test
    void exceptionInAStepIsToBeMendedBeforeAnythingElse() throws IOException {
        Printed printed = Printed.by("grade", "raise-arms", program("trials = 1 / (trials - trials);"), "--seeds", "1");

        assertThat(printed.exitCode()).isEqualTo(1);
        assertThat(printed.out()).containsOnlyOnce("Hint: think() threw an exception: see the output of the program.");
        assertThat(printed.out() + printed.err()).contains("ArithmeticException");
    }

    @Tag("slow")
    @Test
    void programThatLoopsForEverIsStoppedWithItsLine() throws IOException {
        Printed printed = Printed.by("grade", "raise-arms", program("while (trials == 0) { }"), "--seeds", "1");

        assertThat(printed.exitCode()).isEqualTo(1);
        assertThat(printed.out()).contains("think() has not returned for 4 s; it is in MyArms.java:");
    }

    @Tag("slow")
    @Test
    void programThatTakesAllMemoryCostsOnlyItsPoints() throws IOException {
        Printed printed = Printed.by(
                "grade", "raise-arms", program("while (true) { hoard.add(new byte[10_000_000]); }"), "--seeds", "1");

        assertThat(printed.exitCode()).isEqualTo(1);
        assertThat(printed.out()).contains("0.0 of 10 points").contains("memory");
    }

    @Tag("slow")
    @Test
    void classThatIsNoAgentIsRefused() throws IOException {
        Path file = Files.writeString(folder.resolve("NoRobot.java"), "public class NoRobot {}");

        Printed printed = Printed.by("grade", "raise-arms", file.toString());

        assertThat(printed.exitCode()).isEqualTo(2);
    }

    @Tag("slow")
    @Test
    void exampleTeamEarnsNoPoints() throws IOException {
        Path file = Files.writeString(
                folder.resolve("ScoreAGoal.java"), "public class ScoreAGoal extends org.robonewbie.team.Agent_Team {}");

        Printed printed = Printed.by("grade", "score-a-goal", file.toString());

        assertThat(printed.exitCode()).isEqualTo(2);
        assertThat(printed.err()).contains("ScoreAGoal extends Agent_Team of the example team, which earns no points");
    }

    private String program(String lines) throws IOException {
        return Files.writeString(folder.resolve("MyArms.java"), """
                import java.util.ArrayList;
                import java.util.List;
                import org.robonewbie.agent.Agent;
                import org.robonewbie.nao.Joint;

                public class MyArms extends Agent {
                    static int trials;
                    static final List<byte[]> hoard = new ArrayList<>();

                    @Override
                    protected void think() {
                        %s
                    }

                    private void raise(Joint joint, double goal) {
                        nao.setJointSpeed(joint, nao.getJointAngle(joint) < goal ? 30 : 0);
                    }
                }
                """.formatted(lines))
                .toString();
    }
}

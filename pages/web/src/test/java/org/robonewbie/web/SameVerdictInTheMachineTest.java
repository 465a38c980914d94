package org.robonewbie.web;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.OutputStream;
import java.io.PrintStream;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.exercises.Score;
import org.robonewbie.pagejvm.JavaSource;
import org.robonewbie.pagejvm.Program;
import org.robonewbie.protocol.telemetry.TelemetrySink;
import org.robonewbie.simulator.recording.RecordingTarget;

/** Programs get the same score in the page's interpreter as in Java. */
class SameVerdictInTheMachineTest {

    private static final String HEAD = "import org.robonewbie.agent.Agent;\n";

    static List<Exercise> exercises() {
        return Exercises.all();
    }

    @ParameterizedTest
    @MethodSource("exercises")
    void solutionEarnsTheSameInTheMachineAndInJava(Exercise exercise) {
        Map<String, byte[]> classes = JavaSource.compile(exercise.className(), Solutions.text(exercise));

        Score here = score(exercise, classes, 1);

        assertThat(here)
                .isEqualTo(Solutions.judged(exercise, classes, List.of(1L)).get(0));
        assertThat(here.passed()).as(here.finding()).isTrue();
    }

    @ParameterizedTest
    @MethodSource("exercises")
    void starterProgramEarnsTheSameInTheMachineAndInJava(Exercise exercise) {
        Map<String, byte[]> classes = JavaSource.compile(exercise.className(), exercise.startCode());

        Score here = score(exercise, classes, 2);

        assertThat(here)
                .isEqualTo(Solutions.judged(exercise, classes, List.of(2L)).get(0));
    }

    @Test
    void endlessLoopIsReportedWithItsLine() {
        Score score = score("protected void think() {\nwhile (true) {\n}\n}");

        assertThat(score.finding()).isEqualTo("think() has not returned; it is in RaiseArms.java:4.");
        assertThat(score.passed()).isFalse();
    }

    @Test
    void programThatExitsIsReported() {
        Score score = score("protected void think() {\nSystem.exit(3);\n}");

        assertThat(score.finding())
                .isEqualTo("The program ended the whole process (exit code 3). Does it call System.exit?");
    }

    @Test
    void exceptionInAConstructorIsReportedWithItsLine() {
        Score score = score("public RaiseArms() {\nint[] none = {};\nnone[0]++;\n}");

        assertThat(score.finding()).contains("ArrayIndexOutOfBoundsException").contains("RaiseArms.java:5");
    }

    private static Score score(String body) {
        Map<String, byte[]> classes =
                JavaSource.compile("RaiseArms", HEAD + "public class RaiseArms extends Agent {\n" + body + "\n}\n");
        return score(Exercises.all().get(0), classes, 1);
    }

    private static Score score(Exercise exercise, Map<String, byte[]> classes, long seed) {
        PrintStream nowhere = new PrintStream(OutputStream.nullOutputStream());
        ExerciseTrial trial = new ExerciseTrial(
                exercise,
                seed,
                () -> new StudentController(new Program(List.copyOf(classes.values())), nowhere, TelemetrySink.NONE),
                RecordingTarget.NONE);
        while (!trial.isOver()) {
            trial.cycle();
        }
        return trial.score();
    }
}

package org.robonewbie.app.doctor;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.exercises.Grade;
import org.robonewbie.exercises.grading.ProcessGrader;
import org.robonewbie.nao.file.TemporaryFolder;
import org.robonewbie.programs.process.RobotProcess;
import org.robonewbie.programs.process.Sandbox;

/** Checks grading: writes the starter program of an exercise, compiles it, runs it in its own process, and grades it. */
final class ExerciseCheckup {

    private static final String SUBJECT = "An exercise";
    private static final String ADVICE =
            "Try it manually: robonewbie grade raise-arms --start, then robonewbie grade raise-arms RaiseArms.java";

    private ExerciseCheckup() {}

    static Finding graded() {
        Exercise exercise = Exercises.all().get(0);
        try (TemporaryFolder folder = TemporaryFolder.create("room")) {
            Path file = folder.path().resolve(exercise.fileName());
            Files.writeString(file, exercise.startCode());
            RobotProcess.Request program = new RobotProcess.Request(file.toString(), List.of(), folder.path(), true);
            ProcessGrader grader = new ProcessGrader(1, 1, Sandbox.find(), Optional.empty(), line -> {});
            ProcessGrader.Result result = grader.grade(exercise, program, (seed, score) -> {});
            return of(exercise, result.grade(), result.output());
        } catch (IOException failed) {
            return Finding.broken(SUBJECT, String.valueOf(failed.getMessage()), ADVICE);
        }
    }

    private static Finding of(Exercise exercise, Optional<Grade> grade, List<String> output) {
        return grade.filter(given -> given.trials().stream()
                        .noneMatch(trial -> trial.score().finding().startsWith("The program ended")))
                .map(given -> Finding.well(
                        SUBJECT,
                        String.format(
                                Locale.ROOT,
                                "%s was compiled, run and graded without a network: %.1f points",
                                exercise.name(),
                                given.points())))
                .orElseGet(() -> Finding.broken(
                        SUBJECT,
                        exercise.name() + " could not be graded: "
                                + (output.isEmpty() ? "its program did not start" : output.get(0)),
                        ADVICE));
    }
}

package org.robonewbie.exercises;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Supplier;
import org.robonewbie.programs.process.AbsentProgramException;
import org.robonewbie.programs.process.Departure;
import org.robonewbie.programs.process.ProgramPlace;
import org.robonewbie.programs.process.ProgressWatchdog;
import org.robonewbie.simulator.file.RecordingFile;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.TrialListener;

/** Runs one trial of an exercise and scores it. Used by the command line, tests, the studio and competitions. */
public final class Performance {

    /** Start of the finding for a step that does not return. */
    public static final String ENDLESS = "think() has not returned";

    private static final String FIX_FIRST = "Fix this first; the remaining checks were skipped.";

    private static final String FIX_STEP =
            "think() threw an exception: see the output of the program. Fix that first; the robot did not do what"
                    + " you intended.";

    private Performance() {}

    /**
     * Runs one trial to its end on the current thread.
     *
     * @param exercise the exercise
     * @param seed seed of the random numbers
     * @param student creates a controller that runs the student's program; called once for each robot
     * @param recording file for a recording that can be opened in the studio; empty for none
     * @param listener observes the trial
     * @return the score; 0 points if the program throws an exception or its robots leave the trial
     */
    public static Score of(
            Exercise exercise,
            long seed,
            Supplier<? extends Controller> student,
            Optional<Path> recording,
            TrialListener listener) {
        try {
            return play(exercise, seed, student, recording, listener);
        } catch (VirtualMachineError exhausted) {
            throw exhausted;
        } catch (AbsentProgramException absent) {
            return Score.failed(0, String.valueOf(absent.getMessage()), FIX_FIRST);
        } catch (IOException | RuntimeException | Error mistake) {
            return ofMistake(mistake);
        }
    }

    private static Score play(
            Exercise exercise,
            long seed,
            Supplier<? extends Controller> student,
            Optional<Path> recording,
            TrialListener listener)
            throws IOException {
        Task task = exercise.task().get();
        task.play(
                exercise.seconds(),
                seed,
                RobotStart.TEAM,
                student,
                listener,
                RecordingFile.openIfWanted(recording, sentence -> {}));
        return task.score();
    }

    /**
     * Returns the score of a program that has thrown an exception.
     *
     * @param mistake the exception
     * @return the score, with the failing line of the program in its finding
     */
    public static Score ofMistake(Throwable mistake) {
        return ofThrown(ProgramPlace.of(mistake));
    }

    private static Score ofThrown(String mistake) {
        return Score.failed(0, "The program ended with " + mistake + ".", FIX_FIRST);
    }

    /**
     * Adjusts the score of a trial if robots left early or the program failed in a step.
     *
     * @param score the score before the adjustment
     * @param why the reason for the departure or failure
     * @return the adjusted score
     */
    public static Score of(Score score, Departure why) {
        return switch (why.cause()) {
            case NONE -> score;
            case FAILED_STEP -> score.withHint(FIX_STEP);
            case THROWN -> ofThrown(why.text());
            case ENDLESS -> ofEndlessStep(" for " + ProgressWatchdog.SECONDS + " s", Optional.of(why.text()));
            case IDLE -> Score.failed(0, why.text(), why.advice());
            case EXIT -> ofExit(why.text());
            case MEMORY -> Score.failed(0, "The program used up all its memory (" + why.text() + " MB).", FIX_FIRST);
            case EXCESS -> Score.failed(0, "The program started too many processes.", FIX_FIRST);
        };
    }

    /**
     * Returns the score of a program that is stuck in a step.
     *
     * @param howLong the duration, such as {@code " for 4 s"}; empty if unknown
     * @param place the line that the program is executing; empty if unknown
     * @return the score
     */
    public static Score ofEndlessStep(String howLong, Optional<String> place) {
        return Score.failed(
                0,
                ENDLESS + howLong
                        + place.filter(line -> !line.isEmpty())
                                .map(line -> "; it is in " + line)
                                .orElse("") + ".",
                "think() is called 50 times per second and must return quickly. Is there an" + " infinite loop?");
    }

    /**
     * Returns the score of a program that has terminated its own process.
     *
     * @param exitCode the exit code
     * @return the score
     */
    public static Score ofExit(String exitCode) {
        return Score.failed(
                0,
                "The program ended the whole process (exit code " + exitCode + "). Does it call System.exit?",
                FIX_FIRST);
    }
}

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

/**
 * One trial of an exercise from the empty pitch to the score. All who judge play it: the command line, tests, the studio and
 * competitions.
 */
public final class Performance {

    /** How the finding about a program begins that does not come to the end of a step. */
    public static final String ENDLESS = "think() has not returned";

    /** What to do about a program that could not be tried to the end. */
    private static final String MEND = "Mend this first; the rest was not tried.";

    /** What to do about a program that went on after an exception in a step. */
    private static final String MEND_STEP =
            "think() failed, as the program's own lines above say. Mend that first; what the robot did has little to do with your idea.";

    private Performance() {}

    /**
     * Plays one trial to its end in this thread.
     *
     * @param exercise the exercise
     * @param seed start of all that is left to chance
     * @param student makes a robot with the student's program; asked once for each robot
     * @param recording file for a recording for the studio; empty for none
     * @param listener watches the trial
     * @return the score; a program that throws or goes away has none of the points
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
            return Score.failed(0, String.valueOf(absent.getMessage()), MEND);
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
     * Returns the score of a program that has thrown something.
     *
     * @param mistake what it has thrown
     * @return the score, with the line of the program
     */
    public static Score ofMistake(Throwable mistake) {
        return ofThrown(ProgramPlace.of(mistake));
    }

    private static Score ofThrown(String mistake) {
        return Score.failed(0, "The program ended with " + mistake + ".", MEND);
    }

    /**
     * Returns the score of a trial whose robots have gone before its end, or of one with a mistake on the way.
     *
     * @param score the score without that
     * @param why why they have gone
     * @return the score
     */
    public static Score of(Score score, Departure why) {
        return switch (why.cause()) {
            case NONE -> score;
            case FAILED_STEP -> score.withHint(MEND_STEP);
            case THROWN -> ofThrown(why.text());
            case ENDLESS -> ofEndlessStep(" for " + ProgressWatchdog.SECONDS + " s", Optional.of(why.text()));
            case IDLE -> Score.failed(0, why.text(), why.advice());
            case EXIT -> ofExit(why.text());
            case MEMORY -> Score.failed(0, "The program took all memory (" + why.text() + " MB).", MEND);
            case EXCESS -> Score.failed(0, "The program started too many processes.", MEND);
        };
    }

    /**
     * Returns the score of a program that does not come to the end of a step.
     *
     * @param howLong how long it has been waited for, such as {@code " for 4 s"}; empty if that is not known
     * @param place where it is; empty if that is not known
     * @return the score
     */
    public static Score ofEndlessStep(String howLong, Optional<String> place) {
        return Score.failed(
                0,
                ENDLESS + howLong
                        + place.filter(line -> !line.isEmpty())
                                .map(line -> "; it is in " + line)
                                .orElse("") + ".",
                "think() is called 50 times per second and must return at once. Is there an endless loop?");
    }

    /**
     * Returns the score of a program that has ended itself.
     *
     * @param exitCode what it has called {@code System.exit} with
     * @return the score
     */
    public static Score ofExit(String exitCode) {
        return Score.failed(
                0, "The program ended the whole process (exit code " + exitCode + "). Does it call System.exit?", MEND);
    }
}

package org.robonewbie.exercises;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Supplier;
import org.robonewbie.simulator.file.RecordingFile;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.TrialListener;
import org.robonewbie.trial.guest.AbsentProgramException;

/**
 * One trial of an exercise from the empty pitch to the score. All who judge play it: the command line, tests, the studio and
 * competitions.
 */
public final class Performance {

    /** How the finding about a program begins that does not come to the end of a step. */
    public static final String ENDLESS = "think() has not returned";

    /** What to do about a program that could not be tried to the end. */
    public static final String MEND = "Mend this first; the rest was not tried.";

    /** What to do about a program that went on after an exception in a step. */
    public static final String MEND_STEP =
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
        String place = ProgramPlace.in(mistake.getStackTrace())
                .map(line -> " in " + line)
                .orElse("");
        return Score.failed(0, "The program ended with " + mistake + place + ".", MEND);
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
                ENDLESS + howLong + place.map(line -> "; it is in " + line).orElse("") + ".",
                "think() is called 50 times per second and must return at once. Is there an endless loop?");
    }

    /**
     * Returns the score of a program that has ended itself.
     *
     * @param exitCode what it has called {@code System.exit} with
     * @return the score
     */
    public static Score ofExit(int exitCode) {
        return Score.failed(
                0, "The program ended the whole process (exit code " + exitCode + "). Does it call System.exit?", MEND);
    }
}

package org.robonewbie.exercises;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Supplier;
import org.robonewbie.simulator.file.RecordingFile;
import org.robonewbie.trial.Audience;
import org.robonewbie.trial.Performer;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.guest.AbsentProgramException;

/**
 * One trial of an exercise from the empty pitch to the score. All who judge play it: the command line, tests, the studio and
 * competitions.
 */
public final class Performance {

    private static final String MEND = "Mend this first; the rest was not tried.";

    private Performance() {}

    /**
     * Plays one trial to its end in this thread.
     *
     * @param exercise the exercise
     * @param seed start of all that is left to chance
     * @param student makes a robot with the student's program; asked once for each robot
     * @param recording file for a recording for the studio; empty for none
     * @param audience who looks on
     * @return the score; a program that throws or goes away has none of the points
     */
    public static Score of(
            Exercise exercise,
            long seed,
            Supplier<? extends Performer> student,
            Optional<Path> recording,
            Audience audience) {
        try {
            return play(exercise, seed, student, recording, audience);
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
            Supplier<? extends Performer> student,
            Optional<Path> recording,
            Audience audience)
            throws IOException {
        Task task = exercise.task().get();
        task.play(
                exercise.seconds(),
                seed,
                RobotStart.TEAM,
                student,
                audience,
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
        String place = Patience.place(mistake.getStackTrace())
                .map(line -> " in " + line)
                .orElse("");
        return Score.failed(0, "The program ended with " + mistake + place + ".", MEND);
    }
}

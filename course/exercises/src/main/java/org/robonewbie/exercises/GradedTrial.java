package org.robonewbie.exercises;

import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Supplier;
import org.robonewbie.agent.Agent;
import org.robonewbie.programs.process.ProgressWatchdog;
import org.robonewbie.trial.Controller;

/** One trial of an exercise with one seed. Another thread may check whether it is still running. */
record GradedTrial(
        Exercise exercise,
        Supplier<? extends Agent> student,
        long seed,
        Optional<Path> recording,
        ProgressWatchdog progress)
        implements Callable<Score> {

    @Override
    public Score call() {
        progress.begin();
        try {
            return Performance.of(
                    exercise, seed, () -> Controller.ofAgent(student.get()), recording, trial -> progress.progress());
        } finally {
            progress.end();
        }
    }
}

package org.robonewbie.exercises.progress;

import java.io.IOException;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.robonewbie.exercises.Exercise;

/**
 * Stores progress in a file. Without a file, or if the file cannot be read or written, progress is kept in memory until the
 * program ends. Thread-safe.
 */
public final class LocalProgress implements ProgressStore {

    private final Optional<ProgressFile> file;
    private Progress memory = new Progress(Map.of());
    private boolean unusable;
    private boolean damageReported;

    /**
     * Creates the store.
     *
     * @param file the file; empty to keep progress in memory only
     */
    public LocalProgress(Optional<ProgressFile> file) {
        this.file = file;
    }

    private interface Access<T> {
        T to(ProgressFile file) throws IOException;
    }

    @Override
    public synchronized Progress read() {
        return fromFile(ProgressFile::read).orElse(memory);
    }

    @Override
    public synchronized ExerciseProgress update(Exercise exercise, UnaryOperator<ExerciseProgress> change) {
        return fromFile(kept -> kept.update(exercise, change)).orElseGet(() -> {
            ExerciseProgress state = change.apply(memory.of(exercise));
            memory = memory.with(exercise, state);
            return state;
        });
    }

    private <T> Optional<T> fromFile(Access<T> access) {
        if (file.isEmpty() || unusable) {
            return Optional.empty();
        }
        try {
            reportDamage(file.get());
            return Optional.of(access.to(file.get()));
        } catch (IOException problem) {
            unusable = true;
            System.err.println("Your progress cannot be saved to " + file.get().file() + " (" + problem.getMessage()
                    + "). To use another file, set the environment variable " + ProgressFile.SWITCH + ".");
            return Optional.empty();
        }
    }

    private void reportDamage(ProgressFile kept) throws IOException {
        if (!damageReported && kept.isDamaged()) {
            damageReported = true;
            System.err.println(
                    "The progress file " + kept.file() + " is damaged and is treated as empty. Your next attempt"
                            + " renames it to " + kept.damagedFile() + " and starts a new one.");
        }
    }
}

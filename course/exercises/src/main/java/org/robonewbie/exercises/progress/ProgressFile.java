package org.robonewbie.exercises.progress;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.charset.MalformedInputException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.nao.file.AtomicFile;

/**
 * File with a user's progress: {@code .robonewbie/progress.json} in the home folder, unless configured otherwise. The framework
 * does not send it anywhere. Several processes may update the file concurrently.
 *
 * @param file the file; it need not exist
 */
public record ProgressFile(Path file) {

    /** Environment variable that specifies a different progress file; {@code off} disables the storage of progress. */
    public static final String SWITCH = "ROBONEWBIE_PROGRESS";

    private static final Gson GSON = new GsonBuilder().setPrettyPrinting().create();
    private static final Object IN_THIS_PROCESS = new Object();

    /** {@return the file of the current user; empty if progress is not stored} */
    public static Optional<ProgressFile> ofUser() {
        String choice = Optional.ofNullable(System.getenv(SWITCH)).orElse("");
        if (choice.equalsIgnoreCase("off")) {
            return Optional.empty();
        }
        Path usual = Path.of(System.getProperty("user.home", "."), ".robonewbie", "progress.json");
        return Optional.of(new ProgressFile(choice.isEmpty() ? usual : Path.of(choice)));
    }

    /**
     * Reads the progress. Skips exercises with invalid values. A damaged file is treated as empty.
     *
     * @return the progress; empty if there is no file
     * @throws IOException if the file cannot be read
     */
    public Progress read() throws IOException {
        try {
            return Progress.parse(Files.readString(file)).orElse(new Progress(Map.of()));
        } catch (NoSuchFileException | MalformedInputException noneOrNoText) {
            return new Progress(Map.of());
        }
    }

    /**
     * Changes the state of one exercise. Renames a damaged file to {@code NAME.damaged} first.
     *
     * @param exercise the exercise
     * @param change computes the new state from the stored one
     * @return the new state
     * @throws IOException if the file cannot be written
     */
    public ExerciseProgress update(Exercise exercise, UnaryOperator<ExerciseProgress> change) throws IOException {
        Path folder = Objects.requireNonNull(file.toAbsolutePath().getParent());
        Files.createDirectories(folder);
        synchronized (IN_THIS_PROCESS) {
            try (FileChannel channel = FileChannel.open(
                    file.resolveSibling(file.getFileName() + ".lock"),
                    StandardOpenOption.CREATE,
                    StandardOpenOption.WRITE)) {
                channel.lock();
                renameIfDamaged();
                Progress before = read();
                ExerciseProgress state = change.apply(before.of(exercise));
                AtomicFile.write(file, GSON.toJson(before.with(exercise, state).json()) + "\n");
                return state;
            }
        }
    }

    /**
     * Checks whether the file exists but cannot be parsed, for example because a full disk truncated it.
     *
     * @return whether the file is damaged, in which case the next update renames it
     * @throws IOException if the file cannot be read
     */
    public boolean isDamaged() throws IOException {
        try {
            return Progress.parse(Files.readString(file)).isEmpty();
        } catch (NoSuchFileException none) {
            return false;
        } catch (MalformedInputException noText) {
            return true;
        }
    }

    /** {@return the new name of a damaged file} */
    public Path damagedFile() {
        return file.resolveSibling(file.getFileName() + ".damaged");
    }

    private void renameIfDamaged() throws IOException {
        if (isDamaged()) {
            Files.move(file, damagedFile(), StandardCopyOption.REPLACE_EXISTING);
        }
    }
}

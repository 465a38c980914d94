package org.robonewbie.exercises.progress;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
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
import java.util.TreeMap;
import java.util.function.UnaryOperator;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.nao.file.AtomicFile;

/**
 * The file in which a user's progress is kept: {@code .robonewbie/progress.json} in the home folder. It never leaves the computer by
 * itself. Several programs may change it at the same time.
 *
 * @param file the file; it need not exist
 */
public record ProgressFile(Path file) {

    /** Environment variable: {@code off} keeps no progress, anything else is another file. */
    public static final String SWITCH = "ROBONEWBIE_PROGRESS";

    private static final Gson GSON = new GsonBuilder().setPrettyPrinting().create();
    private static final int VERSION = 1;
    private static final Object IN_THIS_PROCESS = new Object();

    /** {@return the file of this user; empty if no progress is kept} */
    public static Optional<ProgressFile> ofUser() {
        String choice = Optional.ofNullable(System.getenv(SWITCH)).orElse("");
        if (choice.equalsIgnoreCase("off")) {
            return Optional.empty();
        }
        Path usual = Path.of(System.getProperty("user.home", "."), ".robonewbie", "progress.json");
        return Optional.of(new ProgressFile(choice.isEmpty() ? usual : Path.of(choice)));
    }

    /**
     * Reads the progress. What does not make sense is left out, and a file that is none of progress is put aside as {@code NAME.damaged}
     * when the next progress is written.
     *
     * @return the progress; none if there is no file
     * @throws IOException if the file cannot be read
     */
    public Progress read() throws IOException {
        try {
            return parsed(Files.readString(file)).orElse(new Progress(Map.of()));
        } catch (NoSuchFileException | MalformedInputException noneOrNoText) {
            return new Progress(Map.of());
        }
    }

    /**
     * Changes the state of one exercise.
     *
     * @param exercise the exercise
     * @param change makes the new state of the old one
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
                putAsideIfDamaged();
                Map<String, ExerciseProgress> all = new TreeMap<>(read().exercises());
                ExerciseProgress state = change.apply(all.getOrDefault(exercise.name(), ExerciseProgress.NONE));
                all.put(exercise.name(), state);
                AtomicFile.write(file, json(all));
                return state;
            }
        }
    }

    /**
     * Returns whether the file holds something that is no progress, for example since a full disk has cut it.
     *
     * @return whether it will be put aside when the next progress is written
     * @throws IOException if the file cannot be read
     */
    public boolean isDamaged() throws IOException {
        try {
            return parsed(Files.readString(file)).isEmpty();
        } catch (NoSuchFileException none) {
            return false;
        } catch (MalformedInputException noText) {
            return true;
        }
    }

    /** {@return where a damaged file is put} */
    public Path damagedFile() {
        return file.resolveSibling(file.getFileName() + ".damaged");
    }

    private void putAsideIfDamaged() throws IOException {
        if (isDamaged()) {
            Files.move(file, damagedFile(), StandardCopyOption.REPLACE_EXISTING);
        }
    }

    private static String json(Map<String, ExerciseProgress> states) {
        JsonObject json = new JsonObject();
        json.addProperty("version", VERSION);
        JsonObject exercises = new JsonObject();
        states.forEach((name, state) -> exercises.add(name, GSON.toJsonTree(state)));
        json.add("exercises", exercises);
        return GSON.toJson(json) + "\n";
    }

    private static Optional<Progress> parsed(String text) {
        try {
            JsonElement json = JsonParser.parseString(text);
            if (!json.isJsonObject() || !json.getAsJsonObject().has("exercises")) {
                return Optional.empty();
            }
            Map<String, ExerciseProgress> states = new TreeMap<>();
            json.getAsJsonObject()
                    .getAsJsonObject("exercises")
                    .entrySet()
                    .forEach(entry -> state(entry.getValue()).ifPresent(state -> states.put(entry.getKey(), state)));
            return Optional.of(new Progress(states));
        } catch (JsonParseException | ClassCastException noProgress) {
            return Optional.empty();
        }
    }

    private static Optional<ExerciseProgress> state(JsonElement json) {
        if (!json.isJsonObject()) {
            return Optional.empty();
        }
        JsonObject state = json.getAsJsonObject();
        try {
            return Optional.of(new ExerciseProgress(
                    (int) number(state, "tries"),
                    number(state, "bestPoints"),
                    state.has("passed") && state.get("passed").getAsBoolean(),
                    (long) number(state, "seconds"),
                    (int) number(state, "hints"),
                    state.has("solutionSeen") && state.get("solutionSeen").getAsBoolean(),
                    state.has("lastSeen") ? state.get("lastSeen").getAsString() : ""));
        } catch (RuntimeException nonsense) {
            return Optional.empty();
        }
    }

    private static double number(JsonObject state, String name) {
        return state.has(name) ? state.get(name).getAsDouble() : 0;
    }
}

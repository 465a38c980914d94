package org.robonewbie.exercises.marking;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.nao.text.FileName;
import org.robonewbie.simulator.json.Json;

/**
 * A student's submission in a class without accounts: programs for the assigned exercises, with the classes and motions that
 * they use. It contains no grades. It is sent to the teacher as a link or as a file, both of which contain the JSON of {@link
 * #json}, compressed with gzip.
 *
 * <pre>{@code
 * {"version": 1, "student": "Anna", "seeds": 3, "exercises": ["kick"],
 *  "files": {"Kick.java": "public class Kick …", "motions/swing.txt": "…"}}
 * }</pre>
 *
 * @param student name of the student, valid as a folder name
 * @param seeds number of trials assigned by the teacher
 * @param exercises names of the assigned exercises, which may be unknown to this version
 * @param files file contents by name: Java files, and motions in the folder {@code motions}
 */
public record HandIn(String student, int seeds, List<String> exercises, Map<String, String> files) {

    /** Maximum size in bytes before compression. */
    public static final int MAX_BYTES = 1_000_000;

    /** Maximum number of trials. */
    private static final int MAX_SEEDS = 20;

    /** Advice about a submission that cannot be read. */
    static final String DAMAGED = "It is incomplete or damaged. Ask for it again.";

    private static final String JAVA = ".java";
    private static final String MOTIONS = "motions/";
    private static final String MOTION = ".txt";
    private static final int VERSION = 1;
    private static final int MAX_ENTRIES = 200;

    /**
     * Checks the contents.
     *
     * @throws IllegalArgumentException if a name is invalid or a limit is exceeded; the message gives the reason
     */
    public HandIn {
        check(student, "The name \"" + student + "\"");
        if (seeds < 1 || seeds > MAX_SEEDS) {
            throw new IllegalArgumentException(
                    "The number of trials must be 1 to " + MAX_SEEDS + ", not " + seeds + ".");
        }
        if (exercises.size() > MAX_ENTRIES || files.size() > MAX_ENTRIES) {
            throw new IllegalArgumentException("It contains more than " + MAX_ENTRIES + " files or exercises.");
        }
        files.keySet().forEach(HandIn::checkFile);
        exercises = List.copyOf(exercises);
        files = Collections.unmodifiableMap(new TreeMap<>(files));
    }

    private static void checkFile(String name) {
        boolean isMotion = name.startsWith(MOTIONS) && name.endsWith(MOTION);
        if (!isMotion && !name.endsWith(JAVA)) {
            throw new IllegalArgumentException("The file \"" + name + "\" is neither a Java file nor a motion.");
        }
        String stem = isMotion
                ? name.substring(MOTIONS.length(), Math.max(MOTIONS.length(), name.length() - MOTION.length()))
                : name.substring(0, name.length() - JAVA.length());
        check(stem, "The file name \"" + name + "\"");
    }

    private static void check(String name, String subject) {
        FileName.problem(name).ifPresent(problem -> {
            throw new IllegalArgumentException(subject + " " + problem + ". Choose another name.");
        });
    }

    /**
     * Parses the output of {@link #json}.
     *
     * @param json untrusted text
     * @return the submission
     * @throws IllegalArgumentException if it is damaged, of a newer version, or invalid; the message gives the reason
     */
    public static HandIn parse(String json) {
        try {
            JsonObject read = JsonParser.parseString(json).getAsJsonObject();
            int version = entry(read, "version").getAsInt();
            if (version != VERSION) {
                throw new IllegalArgumentException("It was made by another version of RoboNewbie (format " + version
                        + "; this version reads format " + VERSION + "). Install the newest version.");
            }
            List<String> exercises = new ArrayList<>();
            entry(read, "exercises").getAsJsonArray().forEach(name -> exercises.add(name.getAsString()));
            Map<String, String> files = new TreeMap<>();
            JsonObject texts = entry(read, "files").getAsJsonObject();
            texts.keySet().forEach(name -> files.put(name, entry(texts, name).getAsString()));
            return new HandIn(
                    entry(read, "student").getAsString(), entry(read, "seeds").getAsInt(), exercises, files);
        } catch (JsonParseException
                | IllegalStateException
                | UnsupportedOperationException
                | NumberFormatException damaged) {
            throw new IllegalArgumentException(DAMAGED, damaged);
        }
    }

    private static JsonElement entry(JsonObject read, String name) {
        return Optional.ofNullable(read.get(name)).orElseThrow(() -> new IllegalArgumentException(DAMAGED));
    }

    /** {@return this submission as JSON} */
    public String json() {
        return Json.object(
                        "version", VERSION, "student", student, "seeds", seeds, "exercises", exercises, "files", files)
                .toString();
    }

    /** Returns the exercises for which this submission contains a program. */
    List<Exercise> solved() {
        return Exercises.all().stream()
                .filter(exercise -> files.containsKey(exercise.fileName()))
                .toList();
    }
}

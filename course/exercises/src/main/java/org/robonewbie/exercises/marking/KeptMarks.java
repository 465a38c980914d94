package org.robonewbie.exercises.marking;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.robonewbie.exercises.Grade;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.nao.file.RegularFile;

/**
 * Stored grades in a folder, one file for each student and exercise, so that unchanged programs are not graded again. A file
 * contains the checksum of everything on which the grade depends, and a signature. Files are read before the first program
 * runs; after that, the copy in memory is authoritative, and {@link #repair} restores the files from it.
 */
final class KeptMarks {

    private static final Gson GSON = new GsonBuilder().setPrettyPrinting().create();
    private static final int MAX_BYTES = 1 << 20;

    private final Path folder;
    private final JudgesKey key;
    private final Map<Path, String> remembered = new TreeMap<>();

    /**
     * Opens a folder.
     *
     * @param folder the folder
     * @param key key for signing grades
     */
    KeptMarks(Path folder, JudgesKey key) {
        this.folder = folder;
        this.key = key;
    }

    /** Contents of a file; any field may be missing. */
    private record Kept(
            @Nullable String fingerprint,
            @Nullable Grade grade,
            @Nullable String reason,
            @Nullable String signature) {

        Kept signedWith(@Nullable String other) {
            return new Kept(fingerprint, grade, reason, other);
        }
    }

    /** Returns a program's grade; empty if there is none or the checksum differs. */
    synchronized Optional<Mark> find(Submission submission, String fingerprint) {
        try {
            String text = read(file(submission));
            @Nullable Kept kept = GSON.fromJson(text, Kept.class);
            Optional<Mark> mark = Optional.ofNullable(kept)
                    .filter(read -> fingerprint.equals(read.fingerprint()))
                    .filter(read -> isGenuine(submission, read))
                    .map(read -> new Mark(
                            submission.student(),
                            submission.exercise().name(),
                            Optional.ofNullable(read.grade()),
                            Optional.ofNullable(read.reason()).orElse("")));
            mark.ifPresent(found -> remembered.put(file(submission), text));
            return mark;
        } catch (IOException | RuntimeException unreadable) {
            return Optional.empty();
        }
    }

    synchronized void keep(Submission submission, String fingerprint, Mark mark) throws IOException {
        Kept kept = new Kept(fingerprint, mark.grade().orElse(null), mark.reason(), null);
        String text = GSON.toJson(kept.signedWith(key.sign(signedText(submission, kept)))) + "\n";
        Path file = file(submission);
        remembered.put(file, text);
        Files.createDirectories(folder(submission));
        AtomicFile.write(file, text);
    }

    /** Restores the files that were modified while programs ran, and returns the number of restored files. */
    synchronized int repair() throws IOException {
        int changed = 0;
        for (Map.Entry<Path, String> mark : remembered.entrySet()) {
            if (!isAsRemembered(mark.getKey(), mark.getValue())) {
                AtomicFile.write(mark.getKey(), mark.getValue());
                changed++;
            }
        }
        return changed;
    }

    private static boolean isAsRemembered(Path file, String text) {
        try {
            return read(file).equals(text);
        } catch (IOException gone) {
            return false;
        }
    }

    private static String read(Path file) throws IOException {
        return new String(RegularFile.read(file, MAX_BYTES), StandardCharsets.UTF_8);
    }

    private boolean isGenuine(Submission submission, Kept kept) {
        String signature = Optional.ofNullable(kept.signature()).orElse("");
        return key.hasSigned(signedText(submission, kept.signedWith(null)), signature);
    }

    /** Returns the signed text, which includes the student and the exercise. */
    private static String signedText(Submission submission, Kept kept) {
        return GSON.toJson(
                new String[] {submission.student(), submission.exercise().fullName(), GSON.toJson(kept)});
    }

    private Path folder(Submission submission) {
        return folder.resolve(submission.student());
    }

    private Path file(Submission submission) {
        return folder(submission).resolve(submission.exercise().fullName() + ".json");
    }
}

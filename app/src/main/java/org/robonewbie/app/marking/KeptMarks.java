package org.robonewbie.app.marking;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonParseException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.robonewbie.exercises.Grade;
import org.robonewbie.nao.file.AtomicFile;

/**
 * Marks that are kept in a folder, one file for each student and exercise, so that a program that has not changed is not graded twice.
 * A file carries the fingerprint of all that the mark depends on: the student's folder, the number of seeds, this program.
 */
final class KeptMarks {

    private static final Gson GSON = new GsonBuilder().setPrettyPrinting().create();

    private final Path folder;
    private final int seeds;
    private final String program;

    /**
     * Opens the marks.
     *
     * @param folder where they are
     * @param seeds how many trials each mark has
     * @param program what distinguishes this version of the judge from others
     */
    KeptMarks(Path folder, int seeds, String program) {
        this.folder = folder;
        this.seeds = seeds;
        this.program = program;
    }

    /** What a file holds; anything may be missing. */
    private record Kept(
            @Nullable String fingerprint,
            @Nullable Grade grade,
            @Nullable String reason) {}

    Optional<Mark> find(Submission submission) {
        try {
            @Nullable Kept kept = GSON.fromJson(Files.readString(file(submission)), Kept.class);
            return Optional.ofNullable(kept)
                    .filter(read -> fingerprint(submission).equals(read.fingerprint()))
                    .map(read -> new Mark(
                            submission.student(),
                            submission.exercise().name(),
                            Optional.ofNullable(read.grade()),
                            Optional.ofNullable(read.reason()).orElse("")));
        } catch (IOException | JsonParseException unreadable) {
            return Optional.empty();
        } catch (RuntimeException nonsense) {
            return Optional.empty();
        }
    }

    void keep(Submission submission, Mark mark) throws IOException {
        Path file = file(submission);
        Files.createDirectories(folder(submission));
        AtomicFile.write(
                file, GSON.toJson(new Kept(fingerprint(submission), mark.grade().orElse(null), mark.reason())) + "\n");
    }

    private Path folder(Submission submission) {
        return folder.resolve(submission.student());
    }

    private Path file(Submission submission) {
        return folder(submission).resolve(submission.exercise().fullName() + ".json");
    }

    private String fingerprint(Submission submission) {
        try (Stream<Path> files = Files.walk(submission.folder())) {
            MessageDigest digest = MessageDigest.getInstance("SHA-256");
            digest.update((seeds + " " + program + " " + submission.folder().relativize(submission.file()))
                    .getBytes(StandardCharsets.UTF_8));
            List<Path> all = files.filter(Files::isRegularFile).sorted().toList();
            for (Path each : all) {
                digest.update(submission.folder().relativize(each).toString().getBytes(StandardCharsets.UTF_8));
                digest.update(Files.readAllBytes(each));
            }
            return HexFormat.of().formatHex(digest.digest());
        } catch (IOException unreadable) {
            return "unreadable: " + unreadable.getMessage();
        } catch (NoSuchAlgorithmException impossible) {
            throw new IllegalStateException(impossible);
        }
    }
}

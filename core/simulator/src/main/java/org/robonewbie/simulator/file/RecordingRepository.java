package org.robonewbie.simulator.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.time.LocalDateTime;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import org.robonewbie.nao.file.AtomicFile;

/**
 * The folder for automatic recordings, with a size limit. The oldest recordings are deleted to stay within the limit,
 * even while a run is being recorded. Starred recordings are kept and do not count towards the limit.
 *
 * @param folder the folder, which need not exist
 * @param maxBytes maximum total size of the recordings
 */
public record RecordingRepository(Path folder, long maxBytes) {

    /** Environment variable that disables automatic recording ({@code off}) or selects a different folder. */
    public static final String SWITCH = "ROBONEWBIE_RECORDINGS";

    /** Extension of recordings. */
    public static final String ENDING = ".rec";

    private static final long DEFAULT_BYTES = 300_000_000;
    private static final DateTimeFormatter TIME = DateTimeFormatter.ofPattern("yyyy-MM-dd HH-mm-ss", Locale.ROOT);

    /**
     * Returns the repository of the current user.
     *
     * @return the repository in {@code .robonewbie/recordings} in the home directory or in the folder specified by
     *     {@link #SWITCH}; empty if automatic recording is disabled
     */
    public static Optional<RecordingRepository> ofUser() {
        String choice = Optional.ofNullable(System.getenv(SWITCH)).orElse("");
        if (choice.equalsIgnoreCase("off")) {
            return Optional.empty();
        }
        Path standard = Path.of(System.getProperty("user.home", "."), ".robonewbie", "recordings");
        return Optional.of(new RecordingRepository(choice.isEmpty() ? standard : Path.of(choice), DEFAULT_BYTES));
    }

    /**
     * Allocates the next recording and deletes old ones if necessary.
     *
     * @param agent name of the program, empty if unknown
     * @return the file, which is named after the current time and does not exist yet; empty if the folder cannot be
     *     used
     */
    public Optional<Path> next(String agent) {
        try {
            Files.createDirectories(folder);
            deleteOldest();
            String name = LocalDateTime.now(ZoneId.systemDefault()).format(TIME);
            Path file = folder.resolve(name + ENDING);
            for (int i = 2; Files.exists(file) || Files.exists(AtomicFile.part(file)); i++) {
                file = folder.resolve(name + " (" + i + ")" + ENDING);
            }
            new RecordingAbout(agent, Path.of("").toAbsolutePath().toString(), false, List.of()).write(file);
            return Optional.of(file);
        } catch (IOException unusable) {
            return Optional.empty();
        }
    }

    /**
     * Lists the recordings.
     *
     * @return the files, newest first; unfinished ones end with {@code .part}
     * @throws IOException if the folder cannot be read
     */
    public List<Path> list() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(RecordingRepository::isRecording)
                    .sorted(Comparator.comparing(RecordingRepository::modified).reversed())
                    .toList();
        } catch (NoSuchFileException none) {
            return List.of();
        }
    }

    /**
     * Deletes the sidecar files of recordings that no longer exist.
     *
     * @throws IOException if the folder cannot be read
     */
    public void tidyUp() throws IOException {
        for (Path file : RecordingGroup.orphans(folder)) {
            Files.deleteIfExists(file);
        }
    }

    /** Deletes the oldest recordings until the rest are within the size limit, but always keeps the newest one. */
    private void deleteOldest() throws IOException {
        long bytes = 0;
        for (Path file : list()) {
            long size = Files.exists(file) && !RecordingAbout.of(file).starred() ? Files.size(file) : 0;
            if (bytes > 0 && bytes + size > maxBytes) {
                new RecordingGroup(file).delete();
            } else {
                bytes += size;
            }
        }
    }

    /** Enforces the size limit during a recording; returns false if this recording alone exceeds the limit or no longer exists. */
    boolean keepLimit(Path file) {
        try {
            deleteOldest();
            return Files.size(AtomicFile.part(file)) < maxBytes;
        } catch (IOException missing) {
            return false;
        }
    }

    /** Returns the user's repository if it contains the file. */
    static Optional<RecordingRepository> of(Path file) {
        return ofUser().filter(repository -> repository
                .folder()
                .toAbsolutePath()
                .equals(file.toAbsolutePath().getParent()));
    }

    private static boolean isRecording(Path file) {
        String name = String.valueOf(file.getFileName());
        return (name.endsWith(ENDING) || name.endsWith(ENDING + AtomicFile.UNFINISHED)) && Files.isRegularFile(file);
    }

    private static long modified(Path file) {
        try {
            return Files.getLastModifiedTime(file).toMillis();
        } catch (IOException missing) {
            return 0;
        }
    }
}

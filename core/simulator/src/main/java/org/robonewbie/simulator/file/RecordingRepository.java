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
 * The folder in which the runs of this user are recorded. It never holds more than a given number of bytes: the oldest recordings
 * make room, also while a run is recorded. Those with a star stay and do not count.
 *
 * @param folder where the recordings are; it need not exist
 * @param mostBytes how much all of them may take
 */
public record RecordingRepository(Path folder, long mostBytes) {

    /** Environment variable: {@code off} records nothing, anything else is another folder. */
    public static final String SWITCH = "ROBONEWBIE_RECORDINGS";

    /** How the names of recordings end. */
    public static final String ENDING = ".rec";

    private static final long DEFAULT_BYTES = 300_000_000;
    private static final DateTimeFormatter TIME = DateTimeFormatter.ofPattern("yyyy-MM-dd HH-mm-ss", Locale.ROOT);

    /**
     * Returns the shelf of this user.
     *
     * @return the shelf in {@code .robonewbie/recordings} of the home directory or where the environment says; empty if
     *     recording is switched off
     */
    public static Optional<RecordingRepository> ofUser() {
        String choice = Optional.ofNullable(System.getenv(SWITCH)).orElse("");
        if (choice.equalsIgnoreCase("off")) {
            return Optional.empty();
        }
        Path usual = Path.of(System.getProperty("user.home", "."), ".robonewbie", "recordings");
        return Optional.of(new RecordingRepository(choice.isEmpty() ? usual : Path.of(choice), DEFAULT_BYTES));
    }

    /**
     * Makes room for the next recording and names it after the time.
     *
     * @param agent name of the program that is run, empty if it is not known
     * @return its file, which does not exist yet; empty if the folder cannot be used
     */
    public Optional<Path> next(String agent) {
        try {
            Files.createDirectories(folder);
            makeRoom();
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
     * @return their files, the newest first; unfinished ones end with {@code .part}
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
     * Removes what lies beside recordings that are gone.
     *
     * @throws IOException if the folder cannot be read
     */
    public void tidyUp() throws IOException {
        for (Path file : RecordingGroup.leftOver(folder)) {
            Files.deleteIfExists(file);
        }
    }

    /** Removes the oldest recordings if all together take too much; the newest stays. */
    private void makeRoom() throws IOException {
        long bytes = 0;
        for (Path file : list()) {
            long size = Files.exists(file) && !RecordingAbout.of(file).starred() ? Files.size(file) : 0;
            if (bytes > 0 && bytes + size > mostBytes) {
                RecordingGroup.of(file).delete();
            } else {
                bytes += size;
            }
        }
    }

    /**
     * Keeps the limit while a run is recorded: older recordings make room.
     *
     * @param file the recording, as {@link #next} has named it
     * @return whether it may grow; false if it takes all the room alone, or does not lie on this shelf's disk any more
     */
    boolean keepLimit(Path file) {
        try {
            makeRoom();
            return Files.size(AtomicFile.part(file)) < mostBytes;
        } catch (IOException gone) {
            return false;
        }
    }

    /** Returns the shelf that a file belongs to. */
    static Optional<RecordingRepository> of(Path file) {
        return ofUser().filter(shelf ->
                shelf.folder().toAbsolutePath().equals(file.toAbsolutePath().getParent()));
    }

    private static boolean isRecording(Path file) {
        String name = String.valueOf(file.getFileName());
        return (name.endsWith(ENDING) || name.endsWith(ENDING + AtomicFile.UNFINISHED)) && Files.isRegularFile(file);
    }

    private static long modified(Path file) {
        try {
            return Files.getLastModifiedTime(file).toMillis();
        } catch (IOException gone) {
            return 0;
        }
    }
}

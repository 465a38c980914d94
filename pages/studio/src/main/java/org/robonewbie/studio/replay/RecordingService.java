package org.robonewbie.studio.replay;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Duration;
import java.time.Instant;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.UnaryOperator;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.nao.text.FileName;
import org.robonewbie.simulator.file.RecordingAbout;
import org.robonewbie.simulator.file.RecordingGroup;
import org.robonewbie.simulator.file.RecordingRepository;

/**
 * Renames, stars, bookmarks, deletes and restores recordings. A deleted recording stays for at least an hour in the
 * folder {@code .removed} next to the other recordings.
 */
final class RecordingService {

    private static final Pattern NAME = Pattern.compile("[\\p{L}\\p{N}][\\p{L}\\p{N} _.,()+-]{0,79}");
    private static final String REMOVED = ".removed";
    private static final Duration STAY = Duration.ofHours(1);

    private final RecordingPlaces places;
    private final Map<String, RecordingGroup> removed = new ConcurrentHashMap<>();

    RecordingService(RecordingPlaces places) {
        this.places = places;
        places.repository().map(RecordingRepository::folder).ifPresent(RecordingService::emptyBin);
        places.projects().forEach(RecordingService::emptyBin);
    }

    synchronized void rename(String from, String to) throws IOException {
        RecordingGroup group = finished(from);
        if (from.equals(to)) {
            return;
        }
        requireValid(to);
        group.moveTo(folderOf(group.recording()), to);
    }

    /** Moves a recording to the bin. */
    synchronized void remove(String name) throws IOException {
        RecordingGroup group = finished(name);
        Path folder = folderOf(group.recording());
        emptyBin(folder);
        Path bin = Files.createDirectories(folder.resolve(REMOVED));
        RecordingGroup target = new RecordingGroup(bin.resolve(group.recording().getFileName()));
        target.delete();
        RecordingGroup moved = group.moveTo(bin, group.name());
        Files.setLastModifiedTime(bin, FileTime.from(Instant.now()));
        removed.put(name, moved);
    }

    /** Restores a recording from the bin. */
    synchronized void bringBack(String name) throws IOException {
        RecordingGroup group = removed.get(name);
        if (group == null || !Files.exists(group.recording())) {
            throw new IllegalArgumentException(
                    "The recording \"" + name + "\" cannot be restored: it was deleted more than an hour ago.");
        }
        requireUnused(name);
        group.moveTo(folderOf(folderOf(group.recording())), group.name());
        removed.remove(name);
    }

    /** Changes the metadata of a recording. */
    synchronized void note(String name, UnaryOperator<RecordingAbout> change) throws IOException {
        Path recording = find(name);
        try {
            change.apply(RecordingAbout.of(recording)).write(recording);
        } catch (IOException e) {
            throw new IOException("cannot write to " + recording.getParent() + " (" + e.getMessage() + ")", e);
        }
    }

    private Path find(String name) throws IOException {
        return places.find(name)
                .orElseThrow(
                        () -> new IllegalArgumentException("This recording no longer exists. Choose another one."));
    }

    private RecordingGroup finished(String name) throws IOException {
        Path file = find(name);
        if (RecordingPlaces.isRunning(file)) {
            throw new IllegalArgumentException(
                    "\"" + name + "\" is still being recorded. Stop the run first, or reset it in the Field room.");
        }
        return new RecordingGroup(file);
    }

    private void requireValid(String name) throws IOException {
        boolean looksLikeFile = name.endsWith(AtomicFile.UNFINISHED) || name.endsWith(RecordingRepository.ENDING);
        if (!NAME.matcher(name).matches() || looksLikeFile || !FileName.isPortable(name)) {
            throw new IllegalArgumentException(
                    "A recording cannot be named \"" + name
                            + "\". Use at most 80 letters, digits, spaces and . , ( ) + - _, beginning with a letter or digit.");
        }
        requireUnused(name);
    }

    private void requireUnused(String name) throws IOException {
        if (places.find(name).isPresent()) {
            throw new IllegalArgumentException(
                    "There is already a recording named \"" + name + "\". Choose another name.");
        }
    }

    private static Path folderOf(Path file) {
        return Objects.requireNonNull(file.toAbsolutePath().getParent());
    }

    /** Empties the bin of a folder if it has not changed for an hour; ignores errors. */
    private static void emptyBin(Path folder) {
        Path bin = folder.resolve(REMOVED);
        try (Stream<Path> files = Files.list(bin)) {
            Instant limit = Instant.now().minus(STAY);
            if (Files.getLastModifiedTime(bin).toInstant().isBefore(limit)) {
                for (Path file : files.toList()) {
                    Files.deleteIfExists(file);
                }
                Files.deleteIfExists(bin);
            }
        } catch (IOException emptyOrInUse) {
            return;
        }
    }
}

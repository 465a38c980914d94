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
 * What people do with recordings: give them other names, stars and bookmarks, delete them and bring them back. A deleted one lies
 * for an hour in the folder {@code .removed} beside the others.
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

    /** Gives a recording another name. */
    synchronized void rename(String from, String to) throws IOException {
        RecordingGroup group = finished(from);
        if (from.equals(to)) {
            return;
        }
        refuse(to);
        group.moveTo(folderOf(group.recording()), to);
    }

    /** Takes a recording away; it can be brought back. */
    synchronized void remove(String name) throws IOException {
        RecordingGroup group = finished(name);
        Path folder = folderOf(group.recording());
        emptyBin(folder);
        Path bin = Files.createDirectories(folder.resolve(REMOVED));
        RecordingGroup target = RecordingGroup.of(bin.resolve(group.recording().getFileName()));
        target.delete();
        RecordingGroup moved = group.moveTo(bin, group.name());
        Files.setLastModifiedTime(bin, FileTime.from(Instant.now()));
        removed.put(name, moved);
    }

    /** Brings a recording back that was taken away. */
    synchronized void bringBack(String name) throws IOException {
        RecordingGroup group = removed.get(name);
        if (group == null || !Files.exists(group.recording())) {
            throw new IllegalArgumentException(
                    "The recording \"" + name + "\" cannot be brought back: it was deleted more than an hour ago.");
        }
        refuseTaken(name);
        group.moveTo(folderOf(folderOf(group.recording())), group.name());
        removed.remove(name);
    }

    /** Changes what is noted beside a recording. */
    synchronized void note(String name, UnaryOperator<RecordingAbout> change) throws IOException {
        Path recording = find(name);
        try {
            change.apply(RecordingAbout.of(recording)).write(recording);
        } catch (IOException e) {
            throw new IOException(
                    "nothing can be written into " + recording.getParent() + " (" + e.getMessage() + ")", e);
        }
    }

    private Path find(String name) throws IOException {
        return places.find(name)
                .orElseThrow(
                        () -> new IllegalArgumentException("There is no such recording any more. Choose another one."));
    }

    private RecordingGroup finished(String name) throws IOException {
        Path file = find(name);
        if (RecordingPlaces.isRunning(file)) {
            throw new IllegalArgumentException(
                    "\"" + name + "\" is being recorded now. End the run first, or reset it in the room Field.");
        }
        return RecordingGroup.of(file);
    }

    private void refuse(String name) throws IOException {
        boolean looksLikeFile = name.endsWith(AtomicFile.UNFINISHED) || name.endsWith(RecordingRepository.ENDING);
        if (!NAME.matcher(name).matches() || looksLikeFile || !FileName.isPortable(name)) {
            throw new IllegalArgumentException(
                    "A recording cannot be named \"" + name
                            + "\". Use letters, digits, blanks and . , ( ) + - _, at most 80, beginning with a letter or digit.");
        }
        refuseTaken(name);
    }

    private void refuseTaken(String name) throws IOException {
        if (places.find(name).isPresent()) {
            throw new IllegalArgumentException("There is a recording \"" + name + "\" already. Choose another name.");
        }
    }

    private static Path folderOf(Path file) {
        return Objects.requireNonNull(file.toAbsolutePath().getParent());
    }

    /** Deletes what has lain in the bin for longer than an hour; a bin that cannot be emptied stays as it is. */
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

package org.robonewbie.studio.replay;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.simulator.file.RecordingAbout;
import org.robonewbie.simulator.file.RecordingGroup;
import org.robonewbie.simulator.file.RecordingRepository;
import org.robonewbie.studio.file.PlainFile;

/**
 * All locations that are searched for recordings: the user's repository, the project, and a file opened by name. Pages can
 * access only the recordings found here, so no path leads out of these folders. A deleted recording is kept for at least an
 * hour in the folder {@code .removed} next to the other recordings.
 */
final class RecordingFolders implements RecordingStore {

    private static final long STILL_RUNNING_MILLIS = 4000;
    private static final String REMOVED = ".removed";
    private static final Duration STAY = Duration.ofHours(1);

    private final Optional<RecordingRepository> repository;
    private final List<Path> projects;
    private final Optional<Path> opened;
    private final RecordingIndexes indexes = new RecordingIndexes();
    private final Map<String, RecordingGroup> removed = new ConcurrentHashMap<>();

    /**
     * Creates the store.
     *
     * @param repository automatically recorded runs; empty if nothing is recorded
     * @param projects folders of the project
     * @param opened a recording in any other folder
     */
    RecordingFolders(Optional<RecordingRepository> repository, List<Path> projects, Optional<Path> opened) {
        this.repository = repository;
        this.projects = List.copyOf(projects);
        this.opened = opened;
        repository.map(RecordingRepository::folder).ifPresent(RecordingFolders::emptyBin);
        projects.forEach(RecordingFolders::emptyBin);
    }

    @Override
    public List<RecordingEntry> all() throws IOException {
        List<RecordingEntry> all = new ArrayList<>();
        for (Map.Entry<String, Path> recording : paths().entrySet()) {
            Path file = recording.getValue();
            RecordingAbout about = RecordingAbout.of(file);
            try {
                long bytes = Files.size(file);
                all.add(new RecordingEntry(
                        recording.getKey(), bytes, isRunning(file), isOfProject(file, about.project()), about));
            } catch (NoSuchFileException justDeleted) {
                // A recording that has just been deleted is omitted.
            }
        }
        return all;
    }

    /** Returns the recording opened by name first, then those in the repository, then those of the project. */
    private Map<String, Path> paths() throws IOException {
        Map<String, Path> all = new LinkedHashMap<>();
        for (Path file : files()) {
            String name = new RecordingGroup(file).name();
            String unique = name;
            for (int i = 2; all.containsKey(unique); i++) {
                unique = name + " [" + i + "]";
            }
            all.put(unique, file);
        }
        return all;
    }

    /**
     * Finds a recording.
     *
     * @throws NoSuchFileException if there is none
     */
    Path file(String name) throws IOException {
        Path file = paths().get(name);
        if (file == null) {
            throw new NoSuchFileException(name);
        }
        return file;
    }

    RecordingIndex index(Path file) throws IOException {
        return indexes.of(file);
    }

    /** Returns whether a recording is in one of the project's folders or was made in the project. */
    private boolean isOfProject(Path file, String madeIn) {
        List<Path> folders = projects.stream()
                .map(folder -> folder.toAbsolutePath().normalize())
                .toList();
        return folders.contains(file.getParent())
                || (!madeIn.isEmpty() && folders.stream().limit(1).anyMatch(Path.of(madeIn)::equals));
    }

    private List<Path> files() throws IOException {
        List<Path> files =
                new ArrayList<>(opened.stream().map(RecordingFolders::present).toList());
        if (repository.isPresent()) {
            for (Path file : repository.get().list()) {
                addIfItLiesThere(file.toAbsolutePath(), files);
            }
        }
        for (Path folder : projects) {
            for (Path file : recordingsIn(folder.toAbsolutePath().normalize())) {
                addIfItLiesThere(file, files);
            }
        }
        return files.stream().distinct().toList();
    }

    /** Returns the current path of a recording, which has another name while it is being written. */
    private static Path present(Path recording) {
        Path file = recording.toAbsolutePath();
        Path part = AtomicFile.part(file);
        return !Files.exists(file) && Files.exists(part) ? part : file;
    }

    private static void addIfItLiesThere(Path file, List<Path> files) {
        if (PlainFile.isInItsFolder(file)) {
            files.add(file);
        }
    }

    private static List<Path> recordingsIn(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(
                            file -> file.toString().endsWith(RecordingRepository.ENDING) && Files.isRegularFile(file))
                    .sorted()
                    .toList();
        } catch (NoSuchFileException | NotDirectoryException none) {
            return List.of();
        }
    }

    @Override
    public Optional<String> folder() {
        return repository.map(place -> place.folder().toString());
    }

    /** Returns whether a recording is complete. */
    static boolean isFinished(Path file) {
        return !file.toString().endsWith(AtomicFile.UNFINISHED);
    }

    /** Returns whether a recording is still being written. */
    static boolean isRunning(Path file) {
        try {
            long age =
                    System.currentTimeMillis() - Files.getLastModifiedTime(file).toMillis();
            return !isFinished(file) && age < STILL_RUNNING_MILLIS;
        } catch (IOException gone) {
            return false;
        }
    }

    private static Path folderOf(Path file) {
        return Objects.requireNonNull(file.toAbsolutePath().getParent());
    }

    /** Empties a folder's bin if the bin has not changed for an hour; ignores errors. */
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

    @Override
    public void write(String name, RecordingAbout about) throws IOException {
        Path file = file(name);
        try {
            about.write(file);
        } catch (IOException e) {
            throw new IOException("cannot write to " + file.getParent() + " (" + e.getMessage() + ")", e);
        }
    }

    @Override
    public void rename(String from, String to) throws IOException {
        Path file = file(from);
        new RecordingGroup(file).moveTo(folderOf(file), to);
    }

    @Override
    public void remove(String name) throws IOException {
        RecordingGroup group = new RecordingGroup(file(name));
        Path folder = folderOf(group.recording());
        emptyBin(folder);
        Path bin = Files.createDirectories(folder.resolve(REMOVED));
        new RecordingGroup(bin.resolve(group.recording().getFileName())).delete();
        removed.put(name, group.moveTo(bin, group.name()));
        Files.setLastModifiedTime(bin, FileTime.from(Instant.now()));
    }

    @Override
    public boolean bringBack(String name) throws IOException {
        RecordingGroup group = removed.get(name);
        if (group == null || !Files.exists(group.recording())) {
            return false;
        }
        group.moveTo(folderOf(folderOf(group.recording())), group.name());
        removed.remove(name);
        return true;
    }

    @Override
    public RunReading read(String name, long milliseconds) throws IOException {
        Path file = file(name);
        RecordingIndex index = index(file);
        index.readOn(file, milliseconds);
        return index.reading();
    }
}

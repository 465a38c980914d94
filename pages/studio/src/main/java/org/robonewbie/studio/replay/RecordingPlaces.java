package org.robonewbie.studio.replay;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.simulator.file.RecordingGroup;
import org.robonewbie.simulator.file.RecordingRepository;
import org.robonewbie.studio.file.PlainFile;

/**
 * All locations where the studio looks for recordings: the user's repository, the project, and a file opened by name.
 * Pages can access only the recordings found here, so no path leads out of these folders.
 *
 * @param repository automatically recorded runs; empty if nothing is recorded
 * @param projects folders of the project
 * @param opened a recording in any other folder
 */
record RecordingPlaces(Optional<RecordingRepository> repository, List<Path> projects, Optional<Path> opened) {

    private static final long STILL_RUNNING_MILLIS = 4000;

    /**
     * {@return all recordings by the names that pages use: first the one opened by name, then those in the repository,
     * then those of the project}
     */
    Map<String, Path> all() throws IOException {
        Map<String, Path> all = new LinkedHashMap<>();
        for (Path file : files()) {
            String name = new RecordingGroup(file).name();
            String unique = name;
            for (int i = 2; all.containsKey(unique) && !all.get(unique).equals(file); i++) {
                unique = name + " [" + i + "]";
            }
            all.put(unique, file);
        }
        return all;
    }

    private List<Path> files() throws IOException {
        List<Path> files =
                new ArrayList<>(opened.stream().map(Path::toAbsolutePath).toList());
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

    Optional<Path> find(String name) throws IOException {
        return Optional.ofNullable(all().get(name));
    }

    /**
     * Returns whether a recording belongs to the project: it is in one of the project's folders or was made in the
     * project.
     */
    boolean isOfProject(Path file, String madeIn) {
        return projects.stream().anyMatch(folder -> isIn(file, folder))
                || (!madeIn.isEmpty()
                        && !projects.isEmpty()
                        && Path.of(madeIn)
                                .equals(projects.get(0).toAbsolutePath().normalize()));
    }

    private static boolean isIn(Path file, Path folder) {
        return folder.toAbsolutePath().normalize().equals(file.getParent());
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
}

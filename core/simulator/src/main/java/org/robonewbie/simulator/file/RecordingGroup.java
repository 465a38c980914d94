package org.robonewbie.simulator.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.robonewbie.nao.file.AtomicFile;

/**
 * A recording and its sidecar files, which have the same name and are moved and deleted together.
 *
 * @param recording the recording file; its name ends with {@code .part} while it is being written
 */
public record RecordingGroup(Path recording) {

    /** Extension of files with log lines and drawings from robots. */
    public static final String NOTES = ".notes";

    /** Extension of files with an index of the recording. */
    public static final String INDEX = ".index";

    /** Extension of files with metadata and the user's annotations. */
    public static final String ABOUT = ".about";

    private static final List<String> SIDECARS = List.of(NOTES, INDEX, ABOUT);

    /** {@return the recording's name without the extension} */
    public String name() {
        String file = String.valueOf(recording.getFileName());
        String finished = withoutEnd(file, AtomicFile.UNFINISHED);
        return withoutEnd(finished, RecordingRepository.ENDING);
    }

    private static String withoutEnd(String text, String end) {
        return text.endsWith(end) ? text.substring(0, text.length() - end.length()) : text;
    }

    /**
     * Returns the path of a sidecar file.
     *
     * @param extension the extension, such as {@link #NOTES}
     * @return the file, which need not exist
     */
    public Path beside(String extension) {
        return recording.resolveSibling(name() + extension);
    }

    /**
     * Moves all files, the recording last, and preserves their modification times.
     *
     * @param folder the target folder; must exist
     * @param newName the new name without an extension
     * @return the moved recording
     * @throws IOException if they cannot be moved
     */
    public RecordingGroup moveTo(Path folder, String newName) throws IOException {
        String extension = String.valueOf(recording.getFileName()).substring(name().length());
        Path target = folder.resolve(newName + extension);
        for (String each : SIDECARS) {
            if (Files.exists(beside(each))) {
                Files.move(beside(each), folder.resolve(newName + each));
            }
        }
        Files.move(recording, target);
        return new RecordingGroup(target);
    }

    /**
     * Deletes all files.
     *
     * @throws IOException if they cannot be deleted
     */
    public void delete() throws IOException {
        Files.deleteIfExists(recording);
        for (String each : SIDECARS) {
            Files.deleteIfExists(beside(each));
        }
    }

    /** Returns the sidecar files in a folder whose recording no longer exists. */
    static List<Path> orphans(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(file -> SIDECARS.stream().anyMatch(file.toString()::endsWith))
                    .filter(file -> !hasRecording(file))
                    .toList();
        }
    }

    private static boolean hasRecording(Path file) {
        String name = String.valueOf(file.getFileName());
        Path recording = file.resolveSibling(name.substring(0, name.lastIndexOf('.')) + RecordingRepository.ENDING);
        return Files.exists(recording) || Files.exists(AtomicFile.part(recording));
    }
}

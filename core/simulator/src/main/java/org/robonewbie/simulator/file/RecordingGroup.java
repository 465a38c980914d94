package org.robonewbie.simulator.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.robonewbie.nao.file.AtomicFile;

/**
 * A recording with the files that are kept beside it under the same name: they are moved and deleted together.
 *
 * @param recording the recording; ends with {@code .part} while it grows
 */
public record RecordingGroup(Path recording) {

    /** How the names of files end that hold what robots logged and drew. */
    public static final String NOTES = ".notes";

    /** How the names of files end that say where everything is in a recording. */
    public static final String INDEX = ".index";

    /** How the names of files end that hold what people have noted. */
    public static final String ABOUT = ".about";

    private static final List<String> BESIDE = List.of(NOTES, INDEX, ABOUT);

    /**
     * Finds the files of a recording.
     *
     * @param recording its file
     * @return it and what lies beside it
     */
    public static RecordingGroup of(Path recording) {
        return new RecordingGroup(recording);
    }

    /** {@return the name of the recording, as people see it} */
    public String name() {
        String file = String.valueOf(recording.getFileName());
        String finished = withoutEnd(file, AtomicFile.UNFINISHED);
        return withoutEnd(finished, RecordingRepository.ENDING);
    }

    private static String withoutEnd(String text, String end) {
        return text.endsWith(end) ? text.substring(0, text.length() - end.length()) : text;
    }

    /**
     * Names a file beside the recording.
     *
     * @param ending such as {@link #NOTES}
     * @return the file, which need not exist
     */
    public Path beside(String ending) {
        return recording.resolveSibling(name() + ending);
    }

    /**
     * Moves all of them, the recording last, and keeps the times of change.
     *
     * @param folder where to; it must exist
     * @param newName how they are called there
     * @return the same recording there
     * @throws IOException if they cannot be moved
     */
    public RecordingGroup moveTo(Path folder, String newName) throws IOException {
        String ending = String.valueOf(recording.getFileName()).substring(name().length());
        Path target = folder.resolve(newName + ending);
        for (String each : BESIDE) {
            if (Files.exists(beside(each))) {
                Files.move(beside(each), folder.resolve(newName + each));
            }
        }
        Files.move(recording, target);
        return new RecordingGroup(target);
    }

    /**
     * Deletes all of them.
     *
     * @throws IOException if they cannot be deleted
     */
    public void delete() throws IOException {
        Files.deleteIfExists(recording);
        for (String each : BESIDE) {
            Files.deleteIfExists(beside(each));
        }
    }

    /**
     * Finds files whose recording is gone.
     *
     * @param folder where recordings are
     * @return the files, which nobody needs any more
     * @throws IOException if the folder cannot be read
     */
    static List<Path> leftOver(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(file -> BESIDE.stream().anyMatch(file.toString()::endsWith))
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

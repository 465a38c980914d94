package org.robonewbie.studio;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.robonewbie.simulator.file.RecordingRepository;

/**
 * The folders that the studio's pages may use; nothing else of the disk can be reached from a page.
 *
 * @param motions where motion files are read and written; it need not exist
 * @param scenes where saved scenes are read and written; it need not exist
 * @param recordings where recordings are read; empty if nothing is recorded
 * @param projects folders of the project in which there may be recordings, the project itself first
 * @param openedRecording a recording that was opened by its name, wherever it is
 */
public record StudioFolders(
        Path motions,
        Path scenes,
        Optional<RecordingRepository> recordings,
        List<Path> projects,
        Optional<Path> openedRecording) {

    private static final String SCENES = "scenes";

    /**
     * Creates folders without an opened recording; scenes lie beside the motions.
     *
     * @param motions where motion files are read and written; it need not exist
     * @param recordings where recordings are read; empty if nothing is recorded
     */
    public StudioFolders(Path motions, Optional<RecordingRepository> recordings) {
        this(motions, motions.resolveSibling(SCENES), recordings, List.of(), Optional.empty());
    }

    /**
     * Opens a recording that lies elsewhere.
     *
     * @param recording its file
     * @return the same folders with this recording
     */
    public StudioFolders withRecording(Path recording) {
        return new StudioFolders(motions, scenes, recordings, projects, Optional.of(recording));
    }

    /**
     * Returns the folders of a program that runs in its project.
     *
     * @return {@code motions} in the working directory, where agents look for motions too, the user's recordings, and
     *     those in the working directory and its folder {@code recordings}
     */
    public static StudioFolders ofWorkingDirectory() {
        List<Path> projects = List.of(Path.of(""), Path.of("recordings"));
        return new StudioFolders(
                Path.of("motions"), Path.of(SCENES), RecordingRepository.ofUser(), projects, Optional.empty());
    }
}

package org.robonewbie.studio;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.robonewbie.simulator.file.RecordingRepository;

/**
 * Folders that the studio's pages may access; they cannot access files anywhere else.
 *
 * @param motions folder of motion files; it need not exist
 * @param scenes folder of saved scenes; it need not exist
 * @param recordings folder of recordings; empty if nothing is recorded
 * @param projects folders of the project that may contain recordings, the project itself first
 * @param openedRecording a recording that was opened by name, in any folder
 */
public record StudioFolders(
        Path motions,
        Path scenes,
        Optional<RecordingRepository> recordings,
        List<Path> projects,
        Optional<Path> openedRecording) {

    private static final String SCENES = "scenes";

    /**
     * Creates the set of studio folders, with no recording open. The scenes folder is a sibling of the motions folder.
     *
     * @param motions folder of motion files; it need not exist
     * @param recordings folder of recordings; empty if nothing is recorded
     */
    public StudioFolders(Path motions, Optional<RecordingRepository> recordings) {
        this(motions, motions.resolveSibling(SCENES), recordings, List.of(), Optional.empty());
    }

    /**
     * Adds a recording from any folder.
     *
     * @param recording file of the recording
     * @return the same folders, with the recording added
     */
    public StudioFolders withRecording(Path recording) {
        return new StudioFolders(motions, scenes, recordings, projects, Optional.of(recording));
    }

    /**
     * Returns the folders for a program that runs in its project folder.
     *
     * @return {@code motions} in the working directory, the user's recordings, and the recordings in the working directory
     *     and its subfolder {@code recordings}
     */
    public static StudioFolders ofWorkingDirectory() {
        List<Path> projects = List.of(Path.of(""), Path.of("recordings"));
        return new StudioFolders(
                Path.of("motions"), Path.of(SCENES), RecordingRepository.ofUser(), projects, Optional.empty());
    }
}

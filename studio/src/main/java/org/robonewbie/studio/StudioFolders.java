package org.robonewbie.studio;

import java.nio.file.Path;
import java.util.Optional;
import org.robonewbie.simulator.recording.RecordingShelf;

/**
 * The folders that the studio's pages may use; nothing else of the disk can be reached from a page.
 *
 * @param motions where motion files are read and written; it need not exist
 * @param recordings where recordings are read; empty if nothing is recorded
 */
public record StudioFolders(Path motions, Optional<RecordingShelf> recordings) {

    /**
     * Gives the folders of a program that runs in its project.
     *
     * @return {@code motions} in the working directory, where agents look for motions too, and the user's recordings
     */
    public static StudioFolders ofWorkingDirectory() {
        return new StudioFolders(Path.of("motions"), RecordingShelf.ofUser());
    }
}

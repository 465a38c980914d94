package org.robonewbie.studio;

import java.nio.file.Path;

/**
 * The folders that the studio's pages may use; nothing else of the disk can be reached from a page.
 *
 * @param motions where motion files are read and written; it need not exist
 */
public record StudioFolders(Path motions) {

    /**
     * Gives the folders of a program that runs in its project.
     *
     * @return {@code motions} in the working directory, where agents look for motions too
     */
    public static StudioFolders ofWorkingDirectory() {
        return new StudioFolders(Path.of("motions"));
    }
}

package org.robonewbie.studio.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Guard against symbolic links that lead out of a folder. */
public final class PlainFile {

    private PlainFile() {}

    /**
     * Returns whether a file is actually in its folder, rather than a link to a file elsewhere.
     *
     * @param file a file
     * @return whether it exists and its real path is below the real path of its folder
     */
    public static boolean isInItsFolder(Path file) {
        Path folder = file.toAbsolutePath().getParent();
        try {
            return folder != null && Files.exists(file) && file.toRealPath().startsWith(folder.toRealPath());
        } catch (IOException gone) {
            return false;
        }
    }
}

package org.robonewbie.studio.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Decides which files pages may reach: those that lie where they seem to lie. */
public final class PlainFile {

    private PlainFile() {}

    /**
     * Whether a file lies in its folder, and not behind a link that leads out of it.
     *
     * @param file a file
     * @return whether it is there and lies below the folder that its path names
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

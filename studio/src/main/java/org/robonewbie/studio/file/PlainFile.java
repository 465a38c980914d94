package org.robonewbie.studio.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Pattern;

/**
 * Decides which files pages may reach: those whose names mean a file on every system, and that lie where they seem to lie.
 *
 * <pre>{@code
 * if (!PlainFile.isName(name)) {
 *     throw new IllegalArgumentException("A scene cannot be named " + name);
 * }
 * }</pre>
 */
public final class PlainFile {

    /** What Windows takes for a device, whatever ending it has. */
    private static final Pattern DEVICE =
            Pattern.compile("(con|prn|aux|nul|(com|lpt)[0-9\u00b9\u00b2\u00b3]) *(\\..*)?", Pattern.CASE_INSENSITIVE);

    private PlainFile() {}

    /**
     * Whether every system can have a file of this name beside others; which letters it has is another question.
     *
     * @param name a name without folder, with or without ending
     * @return false for what Windows takes for a device, and for a blank or dot at the end, which it drops
     */
    public static boolean isName(String name) {
        return !DEVICE.matcher(name).matches() && !name.endsWith(".") && !name.endsWith(" ");
    }

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

package org.robonewbie.simulator.embedded;

import java.io.IOException;
import java.net.URI;
import java.nio.file.DirectoryStream;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.time.Instant;
import java.util.Locale;
import java.util.Set;

/**
 * A local HTML file that redirects a browser to an address. Only the current user can read it, unlike a browser's command line.
 *
 * <p>On Linux, it is stored in a visible folder in the home directory, because browsers installed from Snap and Flatpak
 * can read neither hidden folders nor {@code /tmp}. The file and the folder are deleted when this process ends.
 */
public final class RedirectPage {

    /** Name of the folder in the home directory. */
    static final String FOLDER = "robonewbie-browser";

    /** Time for which an address is valid. */
    private static final Duration LIFETIME = Duration.ofMinutes(10);

    private static final String PREFIX = "open-";
    private static final String SUFFIX = ".html";
    private static final Set<PosixFilePermission> OWNER_ONLY = PosixFilePermissions.fromString("rwx------");

    private RedirectPage() {}

    /**
     * Writes a page.
     *
     * @param address target of the redirect
     * @return the file
     * @throws IOException if it cannot be written
     */
    public static Path write(URI address) throws IOException {
        String system = System.getProperty("os.name", "").toLowerCase(Locale.ROOT);
        return system.contains("linux")
                ? write(address, Path.of(System.getProperty("user.home", ".")))
                : writeInto(Files.createTempDirectory(FOLDER), address);
    }

    /** Writes a page to a folder in the home directory, or to a temporary folder if that fails. */
    static Path write(URI address, Path home) throws IOException {
        try {
            return writeInto(folderIn(home), address);
        } catch (IOException readOnly) {
            return writeInto(Files.createTempDirectory(FOLDER), address);
        }
    }

    private static Path folderIn(Path home) throws IOException {
        Path folder = home.resolve(FOLDER);
        if (!Files.isDirectory(folder, LinkOption.NOFOLLOW_LINKS)) {
            Files.createDirectory(folder, attributes());
        }
        deleteOldPagesIn(folder);
        return folder;
    }

    /** Deletes expired pages left by killed processes. */
    private static void deleteOldPagesIn(Path folder) throws IOException {
        FileTime limit = FileTime.from(Instant.now().minus(LIFETIME));
        try (DirectoryStream<Path> pages = Files.newDirectoryStream(folder, PREFIX + "*" + SUFFIX)) {
            for (Path page : pages) {
                if (Files.getLastModifiedTime(page).compareTo(limit) < 0) {
                    Files.deleteIfExists(page);
                }
            }
        }
    }

    private static Path writeInto(Path folder, URI address) throws IOException {
        folder.toFile().deleteOnExit();
        Path page = Files.createTempFile(folder, PREFIX, SUFFIX); // readable by the owner only
        page.toFile().deleteOnExit();
        return Files.writeString(page, text(address));
    }

    private static FileAttribute<?>[] attributes() {
        return FileSystems.getDefault().supportedFileAttributeViews().contains("posix")
                ? new FileAttribute<?>[] {PosixFilePermissions.asFileAttribute(OWNER_ONLY)}
                : new FileAttribute<?>[0];
    }

    private static String text(URI address) {
        String link = address.toString()
                .replace("&", "&amp;")
                .replace("\"", "&quot;")
                .replace("'", "&#39;")
                .replace("<", "&lt;");
        return """
                <!doctype html>
                <html lang="en"><meta charset="utf-8"><title>RoboNewbie Studio</title>
                <meta name="referrer" content="no-referrer">
                <meta http-equiv="refresh" content="0; url='%s'">
                <p>Opening the studio. If nothing happens, click here: <a href="%s">RoboNewbie Studio</a></p>
                """.formatted(link, link);
    }
}

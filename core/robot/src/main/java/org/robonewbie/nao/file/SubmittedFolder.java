package org.robonewbie.nao.file;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.function.Predicate;
import org.robonewbie.nao.text.PrintableText;

/**
 * An untrusted folder that was submitted for grading or a competition. It may contain regular files only, within limits
 * on their number and total size. Symbolic links are followed within the folder and rejected if they point outside it;
 * hard links count as regular files. Rejected files are never opened.
 *
 * <pre>{@code
 * new SubmittedFolder(Path.of("submissions/anna"), folder -> folder.endsWith("target")).copyTo(workFolder);
 * }</pre>
 *
 * @param root the folder, or a single file
 * @param leftOut selects folders below the root to ignore
 */
public record SubmittedFolder(Path root, Predicate<Path> leftOut) {

    /** Maximum total size of all files in bytes. */
    public static final long MAX_BYTES = 100_000_000;

    /** Maximum number of files and folders. */
    public static final int MAX_FILES = 10_000;

    /** Maximum nesting depth of folders. */
    public static final int MAX_DEPTH = 40;

    /**
     * Checks and lists the folder.
     *
     * @return all files in a fixed order; for a single file, the file itself
     * @throws UnreadableFileException if a file is rejected; the message identifies the file and says what to do
     */
    public List<Path> files() throws UnreadableFileException {
        Inspection inspection = new Inspection(realRoot());
        inspection.visit(root, List.of());
        inspection.files.sort(
                Comparator.comparing(file -> root.relativize(file).toString().replace('\\', '/')));
        return List.copyOf(inspection.files);
    }

    /**
     * Copies the files, replacing links with their targets.
     *
     * @param target the folder for the copies; created if necessary
     * @throws UnreadableFileException if a file is rejected
     * @throws IOException if the copies cannot be written
     */
    public void copyTo(Path target) throws IOException {
        List<Path> files = files();
        Files.createDirectories(target);
        for (Path file : files) {
            Path copy = target.resolve(root.relativize(file).toString());
            Files.createDirectories(Objects.requireNonNull(copy.getParent()));
            Files.copy(file, copy, StandardCopyOption.REPLACE_EXISTING);
        }
    }

    /** Resolves the root, which must not be a link: its target could be another submission. */
    private Path realRoot() throws UnreadableFileException {
        if (Files.isSymbolicLink(root)) {
            throw refused(root, "is a link. Replace it with its target, or name the target.");
        }
        try {
            return root.toRealPath();
        } catch (IOException missing) {
            throw refused(root, "does not exist or cannot be read. Check the name.");
        }
    }

    private static UnreadableFileException refused(Path file, String problem) {
        return new UnreadableFileException(file, problem);
    }

    /** A single pass over the folder. */
    private final class Inspection {

        private final Path realRoot;
        private final List<Path> files = new ArrayList<>();
        private int count;
        private long bytes;

        Inspection(Path realRoot) {
            this.realRoot = realRoot;
        }

        void visit(Path path, List<Path> above) throws UnreadableFileException {
            if (!path.equals(root) && !Files.isRegularFile(path, LinkOption.NOFOLLOW_LINKS) && leftOut.test(path)) {
                return;
            }
            Path real = real(path);
            BasicFileAttributes attributes = attributes(path, real);
            if (attributes.isDirectory()) {
                visitFolder(path, real, above);
            } else if (attributes.isRegularFile()) {
                bytes += attributes.size();
                files.add(path);
            } else {
                throw refused(
                        path, "is not a regular file but a device, a pipe or a socket. Remove it from the folder.");
            }
            checkLimits();
        }

        private void visitFolder(Path folder, Path real, List<Path> above) throws UnreadableFileException {
            if (above.contains(real)) {
                throw refused(folder, "is a link to a folder that contains it. Remove it from the folder.");
            }
            if (above.size() >= MAX_DEPTH) {
                throw refused(folder, "is nested more than " + MAX_DEPTH + " folders deep. Reduce the nesting.");
            }
            List<Path> within = new ArrayList<>(above);
            within.add(real);
            try (DirectoryStream<Path> entries = Files.newDirectoryStream(folder)) {
                for (Path entry : entries) {
                    visit(entry, within);
                }
            } catch (UnreadableFileException known) {
                throw known;
            } catch (IOException unreadable) {
                throw refused(folder, "cannot be read. Change its permissions, or remove it from the folder.");
            }
        }

        /** Resolves a symbolic link; returns any other path unchanged. */
        private Path real(Path path) throws UnreadableFileException {
            if (!Files.isSymbolicLink(path)) {
                return path.equals(root) ? realRoot : path;
            }
            try {
                Path target = path.toRealPath();
                if (!target.startsWith(realRoot)) {
                    throw refused(path, "is a link that leads out of the folder. Replace it with a copy.");
                }
                return target;
            } catch (NoSuchFileException dead) {
                throw refused(path, "is a broken link. Remove it from the folder.");
            } catch (FileSystemException circle) {
                throw refused(path, "is a circular link. Remove it from the folder.");
            } catch (UnreadableFileException known) {
                throw known;
            } catch (IOException unreadable) {
                throw refused(path, "is a link that cannot be followed. Remove it from the folder.");
            }
        }

        private BasicFileAttributes attributes(Path path, Path real) throws UnreadableFileException {
            try {
                return Files.readAttributes(real, BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS);
            } catch (IOException gone) {
                throw refused(path, "cannot be read. Change its permissions, or remove it from the folder.");
            }
        }

        private void checkLimits() throws UnreadableFileException {
            count++;
            if (bytes > MAX_BYTES) {
                throw tooMuch(MAX_BYTES / 1_000_000 + " MB");
            }
            if (count > MAX_FILES) {
                throw tooMuch(MAX_FILES + " files");
            }
        }

        private UnreadableFileException tooMuch(String limit) {
            return new UnreadableFileException("The folder " + PrintableText.of(root.toString())
                    + " contains more than " + limit + ". Choose a folder that contains only the program.");
        }
    }
}

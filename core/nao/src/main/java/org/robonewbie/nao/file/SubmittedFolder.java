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
 * A folder that a stranger has handed in. Only its regular files are admitted, of a number and size that make sense; a link is
 * followed within the folder and refused if it leads out of it, and nothing that is refused is opened. A hard link is a regular
 * file.
 *
 * <pre>{@code
 * new SubmittedFolder(Path.of("submissions/anna"), folder -> folder.endsWith("target")).copyTo(workFolder);
 * }</pre>
 *
 * @param root the folder, or a single file
 * @param leftOut folders below it that are not looked at
 */
public record SubmittedFolder(Path root, Predicate<Path> leftOut) {

    /** The size of all files together that is admitted, in bytes. */
    public static final long MAX_BYTES = 100_000_000;

    /** How many files and folders are admitted. */
    public static final int MAX_FILES = 10_000;

    /** How many folders may lie within each other. */
    public static final int MAX_DEPTH = 40;

    /**
     * Looks at the folder.
     *
     * @return its files in a fixed order; a file is its own list
     * @throws UnreadableFileException if something in it is refused; the message names the file and says what to do
     */
    public List<Path> files() throws UnreadableFileException {
        Inspection inspection = new Inspection(realRoot());
        inspection.visit(root, List.of());
        inspection.files.sort(
                Comparator.comparing(file -> root.relativize(file).toString().replace('\\', '/')));
        return List.copyOf(inspection.files);
    }

    /**
     * Copies the admitted files; what a link leads to becomes a file.
     *
     * @param target the folder for the copies; it is made
     * @throws UnreadableFileException if something in the folder is refused
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

    /** The folder itself is no link: it would be the work of someone else. */
    private Path realRoot() throws UnreadableFileException {
        if (Files.isSymbolicLink(root)) {
            throw refused(root, "is a link. Put in its place what it leads to, or name that.");
        }
        try {
            return root.toRealPath();
        } catch (IOException missing) {
            throw refused(root, "does not exist or cannot be read. Is its name right?");
        }
    }

    private static UnreadableFileException refused(Path file, String problem) {
        return new UnreadableFileException(file, problem);
    }

    /** Goes through the folder once. */
    private final class Inspection {

        private final Path realRoot;
        private final List<Path> files = new ArrayList<>();
        private int count;
        private long bytes;

        Inspection(Path realRoot) {
            this.realRoot = realRoot;
        }

        void visit(Path place, List<Path> above) throws UnreadableFileException {
            if (!place.equals(root) && !Files.isRegularFile(place, LinkOption.NOFOLLOW_LINKS) && leftOut.test(place)) {
                return;
            }
            Path real = real(place);
            BasicFileAttributes attributes = attributes(place, real);
            if (attributes.isDirectory()) {
                visitFolder(place, real, above);
            } else if (attributes.isRegularFile()) {
                bytes += attributes.size();
                files.add(place);
            } else {
                throw refused(place, "is no regular file but a device, a pipe or a socket. Take it out of the folder.");
            }
            refuseTooMuch();
        }

        private void visitFolder(Path folder, Path real, List<Path> above) throws UnreadableFileException {
            if (above.contains(real)) {
                throw refused(folder, "is a link to a folder in which it lies itself. Take it out of the folder.");
            }
            if (above.size() >= MAX_DEPTH) {
                throw refused(folder, "lies more than " + MAX_DEPTH + " folders deep. Hand in fewer folders.");
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
                throw refused(folder, "cannot be read. Change its permissions, or take it out of the folder.");
            }
        }

        /** What is looked at: the place itself, or what a link leads to. */
        private Path real(Path place) throws UnreadableFileException {
            if (!Files.isSymbolicLink(place)) {
                return place.equals(root) ? realRoot : place;
            }
            try {
                Path target = place.toRealPath();
                if (!target.startsWith(realRoot)) {
                    throw refused(place, "is a link that leads out of the folder. Put a copy in its place.");
                }
                return target;
            } catch (NoSuchFileException dead) {
                throw refused(place, "is a link to nothing. Take it out of the folder.");
            } catch (FileSystemException circle) {
                throw refused(place, "is a link that leads in a circle. Take it out of the folder.");
            } catch (UnreadableFileException known) {
                throw known;
            } catch (IOException unreadable) {
                throw refused(place, "is a link that cannot be followed. Take it out of the folder.");
            }
        }

        private BasicFileAttributes attributes(Path place, Path real) throws UnreadableFileException {
            try {
                return Files.readAttributes(real, BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS);
            } catch (IOException gone) {
                throw refused(place, "cannot be read. Change its permissions, or take it out of the folder.");
            }
        }

        private void refuseTooMuch() throws UnreadableFileException {
            count++;
            if (bytes > MAX_BYTES) {
                throw tooMuch(MAX_BYTES / 1_000_000 + " MB");
            }
            if (count > MAX_FILES) {
                throw tooMuch(MAX_FILES + " files");
            }
        }

        private UnreadableFileException tooMuch(String limit) {
            return new UnreadableFileException("The folder " + PrintableText.of(root.toString()) + " has more than "
                    + limit + ". Name a folder that has only the program in it.");
        }
    }
}

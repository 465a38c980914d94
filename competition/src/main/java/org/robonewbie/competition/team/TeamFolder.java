package org.robonewbie.competition.team;

import java.io.IOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Stream;

/**
 * What counts of a team's folder: all files but those that tools have made, those that are hidden, and the results of contests,
 * which change while the team plays.
 */
public final class TeamFolder {

    /** A file in each folder of results. */
    public static final String RESULTS_LOCK = "competition.lock";

    private static final Set<String> MADE_BY_TOOLS =
            Set.of("target", "build", "out", "bin", "node_modules", "__pycache__");
    private static final long MOST_BYTES = 100_000_000;

    private TeamFolder() {}

    /** The files in a fixed order; a file is its own list. */
    static List<Path> filesOf(Path place) throws IOException {
        List<Path> files = new ArrayList<>();
        Files.walkFileTree(place, new SimpleFileVisitor<>() {
            private long bytes;

            @Override
            public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes) {
                String name = String.valueOf(folder.getFileName());
                boolean left = !folder.equals(place)
                        && (name.startsWith(".")
                                || MADE_BY_TOOLS.contains(name)
                                || Files.exists(folder.resolve(RESULTS_LOCK)));
                return left ? FileVisitResult.SKIP_SUBTREE : FileVisitResult.CONTINUE;
            }

            @Override
            public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
                bytes += attributes.size();
                if (bytes > MOST_BYTES) {
                    throw new WrongEntryException("The folder " + place + " has more than " + MOST_BYTES / 1_000_000
                            + " MB. Name a folder that has only the team's program in it.");
                }
                files.add(file);
                return FileVisitResult.CONTINUE;
            }
        });
        files.sort(
                Comparator.comparing(file -> place.relativize(file).toString().replace('\\', '/')));
        return files;
    }

    /** Copies what counts. */
    static void copy(Path from, Path to) throws IOException {
        for (Path file : filesOf(from)) {
            Path copy = to.resolve(from.relativize(file).toString());
            Files.createDirectories(Objects.requireNonNull(copy.getParent()));
            Files.copy(file, copy, StandardCopyOption.REPLACE_EXISTING);
        }
    }

    /**
     * Deletes a folder with everything in it, where the system permits it.
     *
     * @param folder the folder; it need not exist
     */
    public static void delete(Path folder) {
        if (!Files.exists(folder)) {
            return;
        }
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                Files.deleteIfExists(file);
            }
        } catch (IOException inUse) {
            // What is left does no harm; that of a contest is deleted before the next one.
        }
    }
}

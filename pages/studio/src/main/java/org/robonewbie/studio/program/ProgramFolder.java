package org.robonewbie.studio.program;

import java.io.IOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.robonewbie.nao.text.FileName;
import org.robonewbie.studio.file.PageFolder;
import org.robonewbie.studio.file.RefusedException;

/**
 * Java files that a page may read and write: those directly in a folder and those in its {@code src/main/java}. They are identified by
 * their path relative to the folder, with slashes.
 */
class ProgramFolder extends PageFolder {

    /** Maximum size of a program in bytes. */
    static final int MAX_BYTES = 1 << 20;

    private static final String ENDING = ".java";
    private static final String SOURCES = "src/main/java";
    private static final String STUDIO = ".studio";
    private static final int MAX_HISTORY_BYTES = 4 << 20;
    private static final int MAX_FILES = 500;
    private static final int MAX_DEPTH = 12;
    static final Pattern PATH = Pattern.compile(
            "(?:[\\p{L}_][\\p{L}\\p{N}_-]{0,79}/){0," + MAX_DEPTH + "}[\\p{L}_$][\\p{L}\\p{N}_$]{0,79}\\.java");

    private final String suffix;

    private ProgramFolder(Path folder, int maxBytes, Optional<PageFolder> drafts, String suffix) {
        super(folder, maxBytes, drafts);
        this.suffix = suffix;
    }

    /** Returns the programs in a folder. */
    static ProgramFolder of(Path folder) {
        return new ProgramFolder(folder, MAX_BYTES, Optional.of(drafts(folder)), "");
    }

    /** Returns the unsaved changes to the programs in a folder. */
    private static ProgramFolder drafts(Path folder) {
        return new ProgramFolder(folder.resolve(STUDIO).resolve("programs"), MAX_BYTES, Optional.empty(), "");
    }

    /** Returns the saved versions of the programs in a folder, as the pages write them; at first, each is empty. */
    static ProgramFolder histories(Path folder) {
        Path place = folder.resolve(STUDIO).resolve("history");
        return new ProgramFolder(place, MAX_HISTORY_BYTES, Optional.empty(), ".json") {
            @Override
            public Optional<byte[]> read(String path) throws IOException {
                return super.read(path).or(() -> Optional.of(new byte[0]));
            }
        };
    }

    /** Returns all files in alphabetical order; of a project, those directly in the folder first. */
    @Override
    public Listing list() throws IOException {
        Stream<String> paths = drafts().isPresent()
                ? Stream.concat(paths(folder(), 1).stream(), paths(folder().resolve(SOURCES), MAX_DEPTH).stream())
                : paths(folder(), MAX_DEPTH + 1).stream();
        return new Listing(folder().toString(), entries(paths), List.of());
    }

    private List<String> paths(Path start, int depth) throws IOException {
        if (!Files.isDirectory(start)) {
            return List.of();
        }
        List<Path> found = new ArrayList<>();
        Files.walkFileTree(start, Set.of(), depth, new SimpleFileVisitor<>() {
            @Override
            public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
                found.add(file);
                return FileVisitResult.CONTINUE;
            }

            /** Skips unreadable folders and files that have just been deleted. */
            @Override
            public FileVisitResult visitFileFailed(Path place, IOException unreadable) throws IOException {
                if (place.equals(start)) {
                    throw unreadable;
                }
                return FileVisitResult.CONTINUE;
            }

            @Override
            public FileVisitResult postVisitDirectory(Path place, @Nullable IOException endedEarly) {
                return FileVisitResult.CONTINUE;
            }
        });
        return found.stream()
                .filter(file -> file.toString().endsWith(ENDING))
                .filter(Files::isRegularFile)
                .map(file -> folder().relativize(file).toString().replace('\\', '/'))
                .filter(path -> PATH.matcher(path).matches())
                .sorted()
                .limit(MAX_FILES)
                .toList();
    }

    @Override
    public String kind() {
        return "program";
    }

    @Override
    public Path file(String path) throws IOException {
        Stream<String> names = Arrays.stream(path.replace(ENDING, "").split("/"));
        if (names.anyMatch(each -> FileName.problem(each).isPresent())
                || !PATH.matcher(path).matches()) {
            throw new RefusedException(
                    400,
                    "\"" + path + "\" is not a valid program name. Use letters, digits and _, such as MyAgent.java.");
        }
        Path file = folder().resolve(path + suffix);
        for (Path each = file; !each.equals(folder()); each = Objects.requireNonNull(each.getParent())) {
            if (Files.exists(each) && !each.toRealPath().startsWith(folder().toRealPath())) {
                throw new RefusedException(403, "\"" + path + "\" is a link to a place outside " + folder() + ".");
            }
        }
        return file;
    }
}

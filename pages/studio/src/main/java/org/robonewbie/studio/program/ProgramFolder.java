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
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.robonewbie.nao.text.FileName;
import org.robonewbie.studio.file.PageFolder;
import org.robonewbie.studio.file.RefusedException;

/**
 * The Java files of a folder that a page may read and write, and nothing else of this computer: those that lie in it, and those of
 * a project's {@code src/main/java}. They are known by their path from the folder on, with slashes.
 */
final class ProgramFolder extends PageFolder {

    /** The largest program that pages read and write, in bytes. */
    static final int MAX_BYTES = 1 << 20;

    private static final String ENDING = ".java";
    private static final String SOURCES = "src/main/java";
    private static final int MOST_FILES = 500;
    private static final int DEEPEST = 12;
    private static final Pattern PATH = Pattern.compile(
            "(?:[\\p{L}_][\\p{L}\\p{N}_-]{0,79}/){0," + DEEPEST + "}[\\p{L}_$][\\p{L}\\p{N}_$]{0,79}\\.java");

    ProgramFolder(Path folder) {
        super(folder, MAX_BYTES);
    }

    /** The files in alphabetical order, those of the folder itself first. */
    List<Entry> list() throws IOException {
        return entries(Stream.concat(paths(folder(), 1).stream(), paths(folder().resolve(SOURCES), DEEPEST).stream()));
    }

    /** All files below the folder, wherever they are. */
    List<Entry> listAll() throws IOException {
        return entries(paths(folder(), DEEPEST + 1).stream());
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

            /** Leaves out a folder that may not be read, and what is gone meanwhile. */
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
                .limit(MOST_FILES)
                .toList();
    }

    @Override
    protected String kind() {
        return "file";
    }

    @Override
    public Path file(String path) throws IOException {
        boolean isPlain = Arrays.stream(path.split("/")).allMatch(FileName::isPortable);
        if (!isPlain || !PATH.matcher(path).matches()) {
            throw new RefusedException(
                    400, "\"" + path + "\" is no name for a program. Use letters, digits and _, such as MyAgent.java.");
        }
        Path file = folder().resolve(path);
        for (Path each = file; !each.equals(folder()); each = Objects.requireNonNull(each.getParent())) {
            if (Files.exists(each) && !each.toRealPath().startsWith(folder().toRealPath())) {
                throw new RefusedException(403, "\"" + path + "\" is a link to a place outside of " + folder() + ".");
            }
        }
        return file;
    }
}

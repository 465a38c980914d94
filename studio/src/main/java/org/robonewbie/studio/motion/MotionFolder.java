package org.robonewbie.studio.motion;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.robonewbie.studio.file.PageFolder;
import org.robonewbie.studio.file.PlainFile;
import org.robonewbie.studio.file.RefusedException;

/** A folder with text files, which pages name without folder and ending. */
final class MotionFolder extends PageFolder {

    private static final String ENDING = ".txt";
    private static final Pattern NAME = Pattern.compile("[\\p{Alnum}_-][\\p{Alnum}._ -]{0,79}");

    MotionFolder(Path folder) {
        super(folder);
    }

    /** The files in alphabetical order. */
    List<Entry> list() throws IOException {
        if (!Files.isDirectory(folder())) {
            return List.of();
        }
        try (Stream<Path> files = Files.list(folder())) {
            return entries(files.filter(Files::isRegularFile)
                    .map(file -> file.getFileName().toString())
                    .filter(name -> name.endsWith(ENDING))
                    .map(name -> name.substring(0, name.length() - ENDING.length()))
                    .filter(MotionFolder::isName)
                    .sorted());
        }
    }

    @Override
    protected String kind() {
        return "motion";
    }

    @Override
    public Path file(String name) throws IOException {
        if (!isName(name)) {
            throw new RefusedException(
                    400,
                    "\"" + name
                            + "\" is no name for a motion. Use letters, digits, blanks, dots, - and _, at most 80.");
        }
        Path file = folder().resolve(name + ENDING);
        if (Files.exists(file) && !PlainFile.isInItsFolder(file)) {
            throw new RefusedException(403, "\"" + name + "\" is a link to a place outside of " + folder() + ".");
        }
        return file;
    }

    private static boolean isName(String name) {
        return NAME.matcher(name).matches() && PlainFile.isName(name);
    }
}

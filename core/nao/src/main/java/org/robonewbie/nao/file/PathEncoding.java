package org.robonewbie.nao.file;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * What this Java can read of the names of files. It decodes them by the locale of the shell: without UTF-8, as under cron and in
 * containers, {@code Übung} becomes {@code ??bung}, which would be another folder.
 */
public final class PathEncoding {

    private static final char UNDECODABLE = '\uFFFD';

    private PathEncoding() {}

    /** {@return the encoding in which Java reads and writes names of files} */
    public static String name() {
        return System.getProperty("sun.jnu.encoding", "UTF-8");
    }

    /** {@return whether all letters can occur in names; the encoding does not matter on Windows, which has names in Unicode} */
    public static boolean isUnicode() {
        return File.separatorChar == '\\' || name().toUpperCase(Locale.ROOT).startsWith("UTF");
    }

    /**
     * Looks for names that could not be decoded, before anything is written to the wrong place.
     *
     * @param words arguments of the program, in which names of files may occur
     * @return a sentence about the working folder or the first word that could not be decoded; empty if all is well
     */
    public static Optional<String> problem(String... words) {
        return Stream.concat(Stream.of(System.getProperty("user.dir", "")), Stream.of(words))
                .filter(PathEncoding::isLost)
                .findFirst()
                .map(PathEncoding::explain);
    }

    /**
     * Explains why a name is refused.
     *
     * @param refused what Java says
     * @return a sentence with what to do
     */
    public static String explain(InvalidPathException refused) {
        return !isUnicode() && refused.getInput().chars().anyMatch(letter -> letter > '~')
                ? explain(refused.getInput())
                : "\"" + refused.getInput() + "\" cannot be the name of a file here: " + refused.getReason() + ".";
    }

    private static String explain(String name) {
        return isUnicode()
                ? "The name \"" + name + "\" is not written in " + name()
                        + ", so that Java cannot open it. Give that file or folder another name."
                : "The name \"" + name + "\" has letters that cannot be read here, since the encoding of this shell is "
                        + name() + ". Write \"export LC_ALL=C.UTF-8\" and start again.";
    }

    /** A name may really have the character that stands for what could not be decoded. */
    private static boolean isLost(String name) {
        try {
            return name.indexOf(UNDECODABLE) >= 0 && !Files.exists(Path.of(name));
        } catch (InvalidPathException unencodable) {
            return true;
        }
    }
}

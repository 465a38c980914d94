package org.robonewbie.nao.file;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The encoding with which Java decodes file names; it depends on the locale of the shell. In a locale without UTF-8, as
 * under cron and in containers, {@code Übung} becomes {@code ??bung}, a different folder.
 */
public final class PathEncoding {

    private static final char UNDECODABLE = '\uFFFD';

    private PathEncoding() {}

    /** {@return the encoding of file names} */
    public static String name() {
        return System.getProperty("sun.jnu.encoding", "UTF-8");
    }

    /** {@return whether file names can contain all letters; always true on Windows, where names are in Unicode} */
    public static boolean isUnicode() {
        return File.separatorChar == '\\' || name().toUpperCase(Locale.ROOT).startsWith("UTF");
    }

    /**
     * Finds file names that could not be decoded, before anything is written to the wrong folder.
     *
     * @param words arguments of the program, which may contain file names
     * @return a sentence about the working folder or the first argument that could not be decoded; empty if there is none
     */
    public static Optional<String> problem(String... words) {
        return Stream.concat(Stream.of(System.getProperty("user.dir", "")), Stream.of(words))
                .filter(PathEncoding::isLost)
                .findFirst()
                .map(PathEncoding::explain);
    }

    /**
     * Explains why a path is invalid.
     *
     * @param refused the exception that Java threw
     * @return a sentence with advice
     */
    public static String explain(InvalidPathException refused) {
        return !isUnicode() && refused.getInput().chars().anyMatch(letter -> letter > '~')
                ? explain(refused.getInput())
                : "\"" + refused.getInput() + "\" is not a valid file name here: " + refused.getReason() + ".";
    }

    private static String explain(String name) {
        return isUnicode()
                ? "The name \"" + name + "\" is not encoded in " + name()
                        + ", so Java cannot open it. Rename that file or folder."
                : "The name \"" + name + "\" contains letters that cannot be decoded, since the encoding of this shell"
                        + " is "
                        + name() + ". Run \"export LC_ALL=C.UTF-8\" and start again.";
    }

    /**
     * Returns whether a name could not be decoded. The name of an existing file does not count, because it may really
     * contain the replacement character.
     */
    private static boolean isLost(String name) {
        try {
            return name.indexOf(UNDECODABLE) >= 0 && !Files.exists(Path.of(name));
        } catch (InvalidPathException unencodable) {
            return true;
        }
    }
}

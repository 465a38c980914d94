package org.robonewbie.app.command;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import java.util.regex.Matcher;

/**
 * Name by which the user's shell finds this program: {@code robonewbie} if it is on the PATH, otherwise with a path, such as
 * {@code ./robonewbie}. Commands in messages use it, so that they can be copied into the terminal.
 *
 * @param text the name
 */
public record ProgramName(String text) {

    private static final String NAME = "robonewbie";

    /** {@return the name for this shell} */
    public static ProgramName here() {
        return of(
                Optional.ofNullable(System.getProperty("robonewbie.home")).map(Path::of),
                Path.of("").toAbsolutePath(),
                Optional.ofNullable(System.getenv("PATH")).orElse(""),
                File.separatorChar);
    }

    /** Returns the name for a shell. Windows also searches the current folder, so the bare name works there. */
    static ProgramName of(Optional<Path> home, Path folder, String searchPath, char separator) {
        boolean known = Arrays.stream(searchPath.split(File.pathSeparator))
                .filter(entry -> !entry.isEmpty())
                .anyMatch(entry -> Files.isExecutable(Path.of(entry, NAME)));
        if (home.isEmpty() || known || separator != '/') {
            return new ProgramName(NAME);
        }
        Path program = home.get().resolve(NAME);
        if (folder.equals(home.get())) {
            return new ProgramName("./" + NAME);
        }
        String near = folder.relativize(program).toString();
        String shown = near.length() < program.toString().length() ? near : program.toString();
        boolean plain = shown.matches("[\\p{L}\\p{N}/._+@%,:=-]+");
        return new ProgramName(plain ? shown : "'" + shown.replace("'", "'\\''") + "'");
    }

    /**
     * Replaces the program name in all commands in a text.
     *
     * @param words text with commands such as {@code robonewbie grade kick}
     * @return the text for this shell
     */
    public String in(String words) {
        return text.equals(NAME)
                ? words
                : words.replaceAll("(?<![\\w./-])robonewbie (?=[a-z-])", Matcher.quoteReplacement(text + " "));
    }
}

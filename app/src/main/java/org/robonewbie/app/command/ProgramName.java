package org.robonewbie.app.command;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import java.util.regex.Matcher;

/**
 * How people have to write the name of this program where they are: {@code robonewbie} if the system finds it, else with its folder, such
 * as {@code ./robonewbie}. So whatever the program proposes can be copied into the terminal.
 *
 * @param text the word
 */
public record ProgramName(String text) {

    private static final String NAME = "robonewbie";

    /** {@return the word for this terminal} */
    public static ProgramName here() {
        return of(
                Optional.ofNullable(System.getProperty("robonewbie.home")).map(Path::of),
                Path.of("").toAbsolutePath(),
                Optional.ofNullable(System.getenv("PATH")).orElse(""),
                File.separatorChar);
    }

    /** Windows looks for programs in the current folder too, so that the bare name is right there. */
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
     * Writes the commands of a text in this way.
     *
     * @param words a text with commands such as {@code robonewbie grade kick}
     * @return the same text for this terminal
     */
    public String in(String words) {
        return text.equals(NAME)
                ? words
                : words.replaceAll("(?<![\\w./-])robonewbie (?=[a-z-])", Matcher.quoteReplacement(text + " "));
    }
}

package org.robonewbie.app.command;

import java.util.Arrays;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The examples below a command's help text, as they can be copied here. A line that is too long for the terminal continues in the next
 * one, farther to the right: first the command, then what it does.
 */
final class HelpExamples {

    private static final String FARTHER = "      ";
    private static final int LEAST_WIDTH = 40;

    private final ProgramName word;
    private final int width;

    HelpExamples(ProgramName word, int width) {
        this.word = word;
        this.width = Math.max(LEAST_WIDTH, width);
    }

    /** {@return the lines below the help text, ready to be printed} */
    String text(String... footer) {
        return Arrays.stream(footer)
                .map(word::in)
                .flatMap(this::lines)
                .map(line -> line.stripTrailing() + System.lineSeparator())
                .collect(Collectors.joining());
    }

    private Stream<String> lines(String line) {
        if (line.length() < width || !line.startsWith("  ")) {
            return wrapped(line, "");
        }
        int indent = line.length() - line.stripLeading().length();
        int gap = line.stripTrailing().indexOf("   ", indent);
        return gap < 0
                ? wrapped(line, FARTHER)
                : Stream.concat(
                        wrapped(line.substring(0, gap), FARTHER),
                        wrapped(FARTHER + line.substring(gap).strip(), FARTHER));
    }

    /** Breaks between words. */
    private Stream<String> wrapped(String line, String indent) {
        int last = line.length() < width ? -1 : line.lastIndexOf(' ', width - 1);
        boolean fits = last <= indent.length() || line.substring(0, last).isBlank();
        return fits
                ? Stream.of(line)
                : Stream.concat(Stream.of(line.substring(0, last)), wrapped(indent + line.substring(last + 1), indent));
    }
}

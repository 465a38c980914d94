package org.robonewbie.app.command;

import java.util.Arrays;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Formatter for the examples below a command's help text. A line that is wider than the terminal is first broken
 * between the command and its description, then wrapped with a hanging indent.
 */
final class HelpExamples {

    private static final String HANGING_INDENT = "      ";
    private static final int MIN_WIDTH = 40;

    private final ProgramName word;
    private final int width;

    HelpExamples(ProgramName word, int width) {
        this.word = word;
        this.width = Math.max(MIN_WIDTH, width);
    }

    /** {@return the formatted lines} */
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
                ? wrapped(line, HANGING_INDENT)
                : Stream.concat(
                        wrapped(line.substring(0, gap), HANGING_INDENT),
                        wrapped(HANGING_INDENT + line.substring(gap).strip(), HANGING_INDENT));
    }

    private Stream<String> wrapped(String line, String indent) {
        int last = line.length() < width ? -1 : line.lastIndexOf(' ', width - 1);
        boolean fits = last <= indent.length() || line.substring(0, last).isBlank();
        return fits
                ? Stream.of(line)
                : Stream.concat(Stream.of(line.substring(0, last)), wrapped(indent + line.substring(last + 1), indent));
    }
}

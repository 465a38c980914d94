package org.robonewbie.app.marking;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/** Keeps the first lines that a program prints, in which the compiler says what is wrong with it. */
final class FirstLines implements Consumer<String> {

    private static final int MOST = 100;
    private static final String ERROR = ": error: ";

    /** How the compiler begins to say that its stack or memory was too small. */
    private static final List<String> OVERTAXED =
            List.of("robonewbie: The compiler cannot read ", "The system is out of resources");

    private final List<String> lines = new ArrayList<>();

    @Override
    public synchronized void accept(String line) {
        if (lines.size() < MOST) {
            lines.add(line);
        }
    }

    /** The first error of the compiler, without the path of the file, or else the first line. */
    synchronized Optional<String> reason(Path file) {
        if (lines.stream().anyMatch(line -> OVERTAXED.stream().anyMatch(line::startsWith))) {
            return Optional.of(
                    "It does not compile: its author nested expressions or blocks too deeply for the compiler.");
        }
        return lines.stream()
                .filter(line -> line.contains(ERROR))
                .map(line -> "It does not compile: " + shortened(line, file))
                .findFirst()
                .or(() -> lines.stream()
                        .filter(line -> !line.isBlank())
                        .map(line -> line.replaceFirst("^robonewbie: ", ""))
                        .findFirst());
    }

    private static String shortened(String line, Path file) {
        String name = String.valueOf(file.getFileName());
        int start = line.indexOf(name + ":");
        return (start < 0 ? line : line.substring(start)).replace(ERROR, ": ");
    }
}

package org.robonewbie.web;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** Published programs: the examples, and those of README and tutorial. */
final class KnownPrograms {

    private static final Path ROOT = Path.of("../..").toAbsolutePath().normalize();
    private static final Path EXAMPLES = ROOT.resolve("course/examples/src/main/java/org/robonewbie/examples");
    private static final Pattern BLOCK = Pattern.compile("(?ms)^```java\\R(.*?)^```");
    private static final Pattern CLASS = Pattern.compile("public (?:final )?class (\\w+)");

    private KnownPrograms() {}

    /**
     * A program.
     *
     * @param name name of its class
     * @param text its source
     */
    record Text(String name, String text) {

        @Override
        public String toString() {
            return name;
        }
    }

    /** {@return the examples with a main method} */
    static List<Text> examples() {
        try (Stream<Path> files = Files.list(EXAMPLES)) {
            return withMain(files.sorted().map(KnownPrograms::read));
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    /** {@return the programs of README and tutorial with a main method} */
    static List<Text> documented() {
        try (Stream<Path> files = Files.list(ROOT.resolve("docs/tutorial"))) {
            List<Path> pages = new ArrayList<>(List.of(ROOT.resolve("README.md")));
            files.filter(file -> file.toString().endsWith(".md")).sorted().forEach(pages::add);
            return withMain(pages.stream()
                    .flatMap(file -> BLOCK.matcher(read(file)).results())
                    .map(block -> block.group(1)));
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    private static List<Text> withMain(Stream<String> texts) {
        List<Text> programs = new ArrayList<>();
        texts.filter(text -> text.contains("void main(")).forEach(text -> {
            Matcher name = CLASS.matcher(text);
            if (name.find()) {
                programs.add(new Text(name.group(1), text));
            }
        });
        return programs;
    }

    private static String read(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }
}

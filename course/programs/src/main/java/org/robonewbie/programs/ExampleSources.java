package org.robonewbie.programs;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.SortedMap;

/** Source code of the examples, and templates for new programs. */
public final class ExampleSources {

    /** Name of the class in the {@linkplain #template templates}. */
    public static final String TEMPLATE = "NewProgram";

    private final SortedMap<String, String> classNames = ExampleCatalogue.classNames();

    /** Looks up the examples on the class path. */
    public ExampleSources() {}

    /** {@return the names of the examples with source code} */
    public List<String> names() {
        return classNames.keySet().stream()
                .filter(name -> text(name).isPresent())
                .toList();
    }

    /**
     * Returns the source code of an example.
     *
     * @param name its simple name
     * @return the source code; empty if there is no such example
     */
    public Optional<String> text(String name) {
        return Optional.ofNullable(classNames.get(name)).flatMap(ApiComments::source);
    }

    /**
     * Creates a new program.
     *
     * @param file file of the new program, which determines its class and package
     * @param example source code of an example; empty for the shortest program that moves a robot
     * @return its source code
     */
    public String startingWith(Path file, Optional<String> example) {
        String name = String.valueOf(file.getFileName()).replace(".java", "");
        String text = template(example).replace(TEMPLATE, name);
        return packageOf(file).map(own -> "package " + own + ";\n\n" + text).orElse(text);
    }

    /**
     * Returns the template of new programs.
     *
     * @param example source code of an example; empty for the shortest program that moves a robot
     * @return source code without a package, whose class is named {@link #TEMPLATE}
     */
    public String template(Optional<String> example) {
        return example.map(this::renamed).orElseGet(ExampleSources::shortest);
    }

    private static String shortest() {
        try (InputStream stream = Objects.requireNonNull(
                ExampleSources.class.getResourceAsStream(TEMPLATE + ".java.txt"), "There is no file " + TEMPLATE)) {
            return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException unreadable) {
            throw new UncheckedIOException("The template of new programs cannot be read", unreadable);
        }
    }

    private String renamed(String example) {
        String text = example.replaceFirst("(?m)^package [\\w.]+;\\s*", "");
        Optional<String> old = classNames.keySet().stream()
                .filter(each -> text.contains("class " + each + " "))
                .findFirst();
        return old.map(each -> text.replaceAll("\\b" + each + "\\b", TEMPLATE)).orElse(text);
    }

    /** Returns the package of a file in a Maven project. */
    private static Optional<String> packageOf(Path file) {
        String folder = Objects.requireNonNull(file.toAbsolutePath().getParent())
                .toString()
                .replace('\\', '/');
        int sources = folder.indexOf("/src/main/java/");
        return sources < 0
                ? Optional.empty()
                : Optional.of(
                        folder.substring(sources + "/src/main/java/".length()).replace('/', '.'));
    }
}

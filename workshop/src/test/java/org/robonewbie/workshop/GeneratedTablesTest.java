package org.robonewbie.workshop;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.policy.file.PolicyFile;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.exercises.Language;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.file.ShippedMotions;

/**
 * Tables of the documentation that are computed from the product. Each stands on one page, between the comments {@code <!--
 * generated: NAME -->} and {@code <!-- end -->}. To update the pages:
 *
 * <pre>./mvnw test -pl workshop -am -Dtest=GeneratedTablesTest -Dsurefire.failIfNoSpecifiedTests=false -Dtables=write</pre>
 */
class GeneratedTablesTest {

    private static final Path POLICIES = Path.of("..", "core", "agent", "src", "main", "resources", "policies");
    private static final Map<String, Supplier<List<String>>> TABLES = new TreeMap<>(Map.of(
            "shipped motions",
            GeneratedTablesTest::motions,
            "shipped policies",
            GeneratedTablesTest::policies,
            "exercises",
            () -> exercises(Language.ENGLISH, "", "exercise", "minutes", "what the robot does"),
            "Aufgaben",
            () -> exercises(Language.GERMAN, "", "Aufgabe", "Minuten", "was der Roboter tut")));

    static Set<String> names() {
        return TABLES.keySet();
    }

    @ParameterizedTest
    @MethodSource("names")
    void onePageHasTheCurrentTable(String name) throws IOException {
        List<PageTable> places = PageTable.all("generated: " + name);
        assertThat(places).as("pages with the table of " + name).hasSize(1);
        String table =
                String.join("\n", Objects.requireNonNull(TABLES.get(name)).get());

        if (System.getProperty("tables", "").equals("write")) {
            places.get(0).replace(table);
        }

        assertThat(PageTable.all("generated: " + name).get(0).text())
                .as("The table is out of date; the comment of this test says how to write it.")
                .isEqualTo(table);
    }

    /** One row for each motion, mirrored ones in the row of the left one, from the comments in its file. */
    private static List<String> motions() {
        Set<String> names = new ShippedMotions().names();
        List<String> rows = new ArrayList<>(header("motion", "what the robot does", "begins", "measured"));
        for (String name : names) {
            String mirrored = name.replace("left", "right");
            if (mirrored.equals(name) && names.contains(name.replace("right", "left")) && name.contains("right")) {
                continue;
            }
            MotionFile file = ShippedMotions.file(name);
            rows.add(row(
                    mirrored.equals(name) ? "`" + name + "`" : "`" + name + "`, mirrored: `" + mirrored + "`",
                    file.property("does").orElse("").replace(" degrees", "°"),
                    file.property("start").orElse(""),
                    file.property("measured")
                            .orElse("")
                            .replaceFirst("; success: .*", "")
                            .replace(" trials, mean ", ", ")
                            .replace(" degrees", "°")));
        }
        return rows;
    }

    private static List<String> policies() {
        List<String> rows = new ArrayList<>(header("policy", "inputs", "joints", "weights"));
        try (Stream<Path> files = Files.list(POLICIES)) {
            files.sorted().forEach(file -> {
                Policy policy = PolicyFile.read(file);
                rows.add(row(
                        "`" + file.getFileName().toString().replace(".policy", "") + "`",
                        String.valueOf(policy.inputs().size()),
                        String.valueOf(policy.outputs().size()),
                        String.valueOf(policy.network().numbers().length)));
            });
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
        return rows;
    }

    private static List<String> exercises(Language language, String... header) {
        List<String> rows = new ArrayList<>(header(header));
        for (Exercise exercise : Exercises.all()) {
            String sheet = PageTable.read(PageTable.DOCS.resolve("exercises/" + language.worksheet(exercise) + ".md"));
            String title = sheet.lines().findFirst().orElse("").replaceFirst("# \\w+ \\d+: ", "");
            rows.add(row(
                    String.valueOf(exercise.number()),
                    "[" + title + "](" + exercise.fullName() + ".md)",
                    String.valueOf(exercise.minutes()),
                    language.translated(exercise.goal())));
        }
        return rows;
    }

    private static List<String> header(String... cells) {
        return List.of(row(cells), "|" + "---|".repeat(cells.length));
    }

    private static String row(String... cells) {
        return ("| " + String.join(" | ", cells) + " |").replace("|  |", "| |");
    }
}

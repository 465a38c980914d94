package org.robonewbie.workshop;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.ExamplesOnT1;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.policy.file.PolicyFile;
import org.robonewbie.competition.contest.Contests;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.exercises.Language;
import org.robonewbie.learning.dataset.Column;
import org.robonewbie.learning.dataset.DataSet;
import org.robonewbie.learning.environment.EnvironmentSpec;
import org.robonewbie.learning.environment.TrainingTask;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Landmark;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.file.ShippedMotions;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.landscape.Thing;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.workshop.load.ExampleLoad;

/**
 * Tables of the documentation that are computed from the product. Each stands on one page, between the comments {@code <!--
 * generated: NAME -->} and {@code <!-- end -->}. To update the pages:
 *
 * <pre>./mvnw test -pl workshop -am -Dtest=GeneratedTablesTest -Dsurefire.failIfNoSpecifiedTests=false -Dtables=write</pre>
 */
class GeneratedTablesTest {

    private static final Path POLICIES = Path.of("..", "core", "agent", "src", "main", "resources", "policies");
    private static final Map<String, Supplier<List<String>>> TABLES = new TreeMap<>(Map.ofEntries(
            Map.entry("shipped motions", GeneratedTablesTest::motions),
            Map.entry("shipped policies", GeneratedTablesTest::policies),
            Map.entry("joints", GeneratedTablesTest::joints),
            Map.entry("examples on a T1", GeneratedTablesTest::examplesOnT1),
            Map.entry("scenes", GeneratedTablesTest::scenes),
            Map.entry("things", GeneratedTablesTest::things),
            Map.entry("contests", GeneratedTablesTest::contests),
            Map.entry("columns", GeneratedTablesTest::columns),
            Map.entry("tasks", GeneratedTablesTest::tasks),
            Map.entry("options of tasks", GeneratedTablesTest::options),
            Map.entry("exercises", () -> exercises(Language.ENGLISH, "", "exercise", "minutes", "what the robot does")),
            Map.entry("Aufgaben", () -> exercises(Language.GERMAN, "", "Aufgabe", "Minuten", "was der Roboter tut"))));

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
                    withSign(file.property("does").orElse("")),
                    file.property("start").orElse(""),
                    withSign(file.property("measured")
                            .orElse("")
                            .replaceFirst("; success: .*", "")
                            .replace(" trials, mean ", ", "))));
        }
        return rows;
    }

    private static List<String> policies() {
        List<String> rows = new ArrayList<>(header("policy", "inputs", "outputs", "weights"));
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

    /** One row for each joint; the direction is from the comment of its constant. */
    private static List<String> joints() {
        String source = PageTable.read(Path.of("../core/robot/src/main/java/org/robonewbie/nao/Joint.java"));
        List<String> rows = new ArrayList<>(
                header("`Joint`", "standard name", "sensor", "motor", "range in degrees", "positive or negative"));
        for (Joint joint : Joint.values()) {
            Matcher comment = Pattern.compile("\\*\\*([^/]*)\\. NAO: [^/]*/\\s+" + joint + "\\(")
                    .matcher(source);
            assertThat(comment.find()).as("comment of " + joint).isTrue();
            rows.add(row(
                    "`" + joint + "`",
                    joint.standardName(),
                    "`" + joint.perceptorName() + "`",
                    "`" + joint.effectorName() + "`",
                    number(joint.minDegrees()) + " to " + number(joint.maxDegrees()),
                    comment.group(1).replaceAll("[\\s*]+", " ").strip()));
        }
        return rows;
    }

    private static List<String> scenes() {
        List<String> rows = new ArrayList<>(header("scene", "what is there", "exercise"));
        Landscape.ALL.stream()
                .filter(scene -> !scene.isBare())
                .forEach(scene ->
                        rows.add(row("`" + scene.name() + "`", withSign(scene.description()), exercisesIn(scene))));
        return rows;
    }

    private static String exercisesIn(Landscape scene) {
        return Exercises.all().stream()
                .filter(exercise -> exercise.task()
                        .get()
                        .scene(new RandomSource(1))
                        .landscape()
                        .equals(scene))
                .map(exercise -> String.format(
                        "[%d %s](exercises/%s.md)", exercise.number(), exercise.title(), exercise.fullName()))
                .collect(Collectors.joining(", "));
    }

    private static List<String> things() {
        List<String> rows =
                new ArrayList<>(header("scene", "thing", "centre x, y (m)", "size along x, y, z (m)", "mass"));
        for (Landscape scene : Landscape.ALL) {
            for (Thing thing : scene.things()) {
                rows.add(row(
                        "`" + scene.name() + "`",
                        thing.name(),
                        metres(thing.centre().x(), thing.centre().y()),
                        metres(thing.size().x(), thing.size().y(), thing.size().z()),
                        thing.isMovable() ? number(thing.massKg()) + " kg" : "fixed"));
            }
        }
        return rows;
    }

    private static String metres(double... lengths) {
        return DoubleStream.of(lengths).mapToObj(GeneratedTablesTest::number).collect(Collectors.joining(", "));
    }

    /** One row for each group of examples to which the framework reports the same restrictions. */
    private static List<String> examplesOnT1() {
        List<List<String>> cells = new ArrayList<>();
        Map<String, Class<? extends Agent>> examples = ExampleLoad.examples();
        examples.remove("Agent_KeyframeDeveloper"); // plays a file that it creates
        examples.forEach((name, type) -> {
            String missing = ExamplesOnT1.missing(ExampleLoad.agents(type).get(0));
            cells.add(List.of(name, missing.isEmpty() ? "everything" : "all but " + missing));
        });
        return grouped(header("example", "what plays on a T1"), cells);
    }

    private static List<String> contests() {
        List<String> rows = new ArrayList<>(header("contest", "what counts"));
        Contests.usual().forEach(contest -> rows.add(row("`" + contest.name() + "`", contest.rule())));
        return rows;
    }

    private static List<String> columns() {
        String joints = choice(Joint.values());
        String landmarks = choice(Landmark.values());
        List<List<String>> cells = new ArrayList<>();
        for (Column column : DataSet.columns()) {
            String name = column.name()
                    .replaceFirst("^" + landmarks + "(?=_)", "LANDMARK")
                    .replaceFirst("(?<=_)" + joints + "$", "JOINT")
                    .replaceFirst("(?<=_)(forward|left|up|[xyz])$|(?<=_q)[wxyz]$", "…");
            cells.add(List.of(name, column.unit(), column.meaning()));
        }
        return grouped(header("columns", "unit", "content"), cells);
    }

    private static String choice(Enum<?>... constants) {
        return Stream.of(constants)
                .map(constant -> constant.name().toLowerCase(Locale.ROOT))
                .collect(Collectors.joining("|", "(", ")"));
    }

    private static List<String> tasks() {
        List<List<String>> cells = new ArrayList<>();
        EnvironmentSpec.tasks()
                .forEach((name, task) -> cells.add(List.of(
                        name,
                        number(task.longestCycles() * Cycle.SECONDS),
                        actions(task),
                        withSign(task.rewardRule()),
                        withSign(task.successRule()))));
        return grouped(header("task", "seconds", "actions", "reward", "success"), cells);
    }

    private static String actions(TrainingTask task) {
        if (task.steersWalk()) {
            return task.outputs().size() + ", the velocity of the walk";
        }
        String corrected = task.motion().map(Motion::name).orElse(task.walk().isPresent() ? "the walk engine" : "");
        DoubleSummaryStatistics ranges =
                task.joints().stream().mapToDouble(task::rangeDegrees).summaryStatistics();
        String least = ranges.getMin() < ranges.getMax() ? number(ranges.getMin()) + "° to " : "";
        return task.outputs().size() + " × " + least + number(ranges.getMax()) + "°"
                + (corrected.isEmpty() ? "" : " from " + corrected);
    }

    private static List<String> options() {
        List<List<String>> cells = new ArrayList<>();
        EnvironmentSpec.meaningOfOptions().forEach((name, meaning) -> cells.add(List.of(name, meaning)));
        return grouped(header("option", "changes"), cells);
    }

    /** Names whose other cells are equal share a row. */
    private static List<String> grouped(List<String> header, List<List<String>> cells) {
        Map<List<String>, Set<String>> names = new LinkedHashMap<>();
        cells.forEach(each -> names.computeIfAbsent(each.subList(1, each.size()), others -> new LinkedHashSet<>())
                .add("`" + each.get(0) + "`"));
        List<String> rows = new ArrayList<>(header);
        names.forEach((others, group) ->
                rows.add(row(Stream.concat(Stream.of(String.join(", ", group)), others.stream())
                        .toArray(String[]::new))));
        return rows;
    }

    /** Returns a number with at most three decimals. */
    private static String number(double value) {
        return String.format(Locale.ROOT, "%.3f", value)
                .replaceFirst("\\.?0+$", "")
                .replace('-', '−');
    }

    private static String withSign(String text) {
        return text.replaceAll("(?<=\\d) degrees", "°");
    }

    private static List<String> header(String... cells) {
        return List.of(row(cells), "|" + "---|".repeat(cells.length));
    }

    private static String row(String... cells) {
        return ("| " + String.join(" | ", cells) + " |").replace("|  |", "| |");
    }
}

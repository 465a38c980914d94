package org.robonewbie.agent;

import java.io.IOException;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import org.robonewbie.agent.cycle.TelemetryPublisher;
import org.robonewbie.agent.log.Diagnostics;
import org.robonewbie.agent.running.PrototypeProbe;
import org.robonewbie.agent.running.Surroundings;
import org.robonewbie.nao.text.Spelling;
import org.robonewbie.protocol.telemetry.TelemetryItem.DeclaredNumber;

/**
 * The tunable numbers that a robot program has declared with {@link Agent#number}. A file in the working directory,
 * named after the program's class, such as {@code Walker.numbers}, overrides their default values:
 *
 * <pre>
 * stride = 0.062
 * patience = 1.5
 * </pre>
 */
public final class TunableNumbers {

    private static final ThreadLocal<Optional<Map<String, Double>>> TRIED = ThreadLocal.withInitial(Optional::empty);

    private static final int CYCLES_UNTIL_PUBLISHED_AGAIN = 50;

    private final String file;
    private final Diagnostics diagnostics;
    private Optional<Map<String, Double>> wanted;
    private final Map<String, TunableNumber> declared = new LinkedHashMap<>();
    private Set<String> declaredAtFirst = Set.of();
    private boolean followed;
    private int cyclesUntilPublished;

    private TunableNumbers(String file, Diagnostics diagnostics, Optional<Map<String, Double>> wanted) {
        this.file = file;
        this.diagnostics = diagnostics;
        this.wanted = wanted;
    }

    /**
     * Returns the name of the file that overrides the numbers of a program.
     *
     * @param type simple name of the program's class
     * @return the file name, such as {@code Walker.numbers}
     */
    public static String fileName(String type) {
        return type + ".numbers";
    }

    /**
     * Creates a robot with the given numbers instead of those in its file.
     *
     * @param values values by name; all other numbers have their default values
     * @param maker creates the robot, in this thread
     * @param <A> the robot's class
     * @return the robot
     */
    public static <A> A with(Map<String, Double> values, Supplier<A> maker) {
        Optional<Map<String, Double>> before = TRIED.get();
        TRIED.set(Optional.of(Map.copyOf(values)));
        try {
            return maker.get();
        } finally {
            TRIED.set(before);
        }
    }

    static TunableNumbers of(String type, Diagnostics diagnostics) {
        return new TunableNumbers(fileName(type), diagnostics, TRIED.get());
    }

    double declare(String name, double usual, double least, double most) {
        TunableNumber known = declared.get(name);
        if (known != null) {
            return known.value();
        }
        if (!(least <= usual && usual <= most && least < most) || Double.isInfinite(most - least)) {
            throw new IllegalArgumentException("number(\"" + name + "\", " + usual + ", " + least + ", " + most
                    + "): expected the default value, then the smallest and the largest value, such as (\"" + name
                    + "\", 5, 0, 10).");
        }
        double requested = wanted().getOrDefault(name, usual);
        TunableNumber number = new TunableNumber(name, usual, least, most, usual).withValue(requested);
        if (number.value() != requested) {
            diagnostics.reportAt(
                    "",
                    "number " + name,
                    () -> name + " = " + requested + " in " + file + " is not between " + least + " and " + most + "; "
                            + number.value() + " is used.");
        }
        declared.put(name, number);
        return number.value();
    }

    List<TunableNumber> list() {
        return List.copyOf(declared.values());
    }

    /**
     * Publishes the numbers of a running robot and applies the values that the viewer requests. Call this method
     * between cycles.
     */
    void follow(Agent robot, TelemetryPublisher viewer) {
        if (!followed) {
            followed = true;
            declaredAtFirst = Set.copyOf(declared.keySet());
        }
        if (declared.isEmpty() || !viewer.isWatched()) {
            return;
        }
        Map<String, Double> wishes = requests(viewer);
        if (!wishes.isEmpty()) {
            Map<String, Double> before = values();
            wishes.forEach((name, value) -> declared.computeIfPresent(name, (same, number) -> number.withValue(value)));
            updateFields(robot, before);
        }
        publish(viewer, !wishes.isEmpty());
    }

    private Map<String, Double> requests(TelemetryPublisher viewer) {
        Map<String, Double> wishes = new HashMap<>();
        for (String name : declared.keySet()) {
            viewer.wish(name).ifPresent(value -> wishes.put(name, value));
        }
        return wishes;
    }

    /**
     * Updates the fields that were initialised from numbers: those that differ between two new instances, one created
     * with the old numbers and one with the new ones.
     */
    private void updateFields(Agent robot, Map<String, Double> before) {
        Map<String, Double> now = values();
        boolean inFields = declaredAtFirst.stream().anyMatch(name -> !Objects.equals(now.get(name), before.get(name)));
        if (!inFields) {
            return;
        }
        Optional<Agent> old = with(before, () -> PrototypeProbe.of(robot));
        Optional<Agent> fresh = with(now, () -> PrototypeProbe.of(robot));
        if (old.isEmpty() || fresh.isEmpty() || !PrototypeProbe.copyDifferences(old.get(), fresh.get(), robot)) {
            diagnostics.reportAt(
                    "",
                    "sliders",
                    () -> "Sliders cannot change fields, since "
                            + robot.getClass().getSimpleName()
                            + "() cannot create a second instance. Call number(...) in think(), where it always"
                            + " returns the value of its slider.");
        }
    }

    /** Publishes the numbers periodically, because viewers connect and disconnect without notice. */
    private void publish(TelemetryPublisher viewer, boolean changed) {
        cyclesUntilPublished--;
        if (changed || cyclesUntilPublished < 0) {
            cyclesUntilPublished = CYCLES_UNTIL_PUBLISHED_AGAIN;
            for (TunableNumber number : declared.values()) {
                viewer.publish(new DeclaredNumber(
                        number.name(), number.usual(), number.least(), number.most(), number.value()));
            }
        }
    }

    private Map<String, Double> values() {
        Map<String, Double> values = new HashMap<>();
        declared.forEach((name, number) -> values.put(name, number.value()));
        return values;
    }

    /**
     * Reports numbers in the file that the program does not declare. Call this method after all numbers have been
     * declared.
     */
    void reportUnknown() {
        for (String name : wanted().keySet()) {
            if (!declared.containsKey(name)) {
                diagnostics.reportAt(
                        "",
                        "number " + name,
                        () -> file + " has a number \"" + name + "\", but the program does not declare it."
                                + Spelling.question(name, declared.keySet()) + " It declares " + declared.keySet()
                                + ".");
            }
        }
    }

    /** Returns the values in the file, which is read on the first call. */
    private Map<String, Double> wanted() {
        Map<String, Double> values = wanted.orElseGet(() -> read(file, diagnostics));
        wanted = Optional.of(values);
        return values;
    }

    private static Map<String, Double> read(String file, Diagnostics diagnostics) {
        Map<String, Double> values = new HashMap<>();
        try {
            Surroundings.properties(file)
                    .forEach((name, text) -> number(text)
                            .ifPresentOrElse(
                                    value -> values.put(name, value),
                                    () -> diagnostics.reportAt(
                                            "",
                                            "number " + name,
                                            () -> name + " = " + text + " in " + file
                                                    + " is not a number; the default value is used.")));
        } catch (IOException unreadable) {
            diagnostics.reportAt("", "numbers", () -> unreadable.getMessage() + " The default values are used.");
        }
        return values;
    }

    private static Optional<Double> number(String text) {
        try {
            return Optional.of(Double.valueOf(text.trim()));
        } catch (NumberFormatException none) {
            return Optional.empty();
        }
    }
}

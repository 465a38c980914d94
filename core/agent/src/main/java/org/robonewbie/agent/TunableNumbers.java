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
 * The numbers that a robot's program has declared by {@link Agent#number}. Other values for them stand in a file with the name of
 * the program's class, such as {@code Walker.numbers}, in the folder in which the program runs:
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
     * Returns the name of the file with other values for the numbers of a program.
     *
     * @param type the program's class
     * @return such as {@code Walker.numbers}
     */
    public static String fileName(String type) {
        return type + ".numbers";
    }

    /**
     * Creates a robot with other numbers than those of its file.
     *
     * @param values value by name; numbers that are not named have their usual value
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
                    + "): give the usual value, then the least and the most it may be, such as (\"" + name
                    + "\", 5, 0, 10).");
        }
        double value = within(name, wanted().getOrDefault(name, usual), usual, least, most);
        declared.put(name, new TunableNumber(name, usual, least, most, value));
        return value;
    }

    List<TunableNumber> list() {
        return List.copyOf(declared.values());
    }

    /**
     * Publishes the numbers of a running robot, and takes over the values that people want of them at the viewer.
     *
     * @param robot the robot, between two cycles
     * @param viewer who sees them
     */
    void follow(Agent robot, TelemetryPublisher viewer) {
        if (!followed) {
            followed = true;
            declaredAtFirst = Set.copyOf(declared.keySet());
        }
        if (declared.isEmpty() || !viewer.isWatched()) {
            return;
        }
        Map<String, Double> wishes = wishes(viewer);
        if (!wishes.isEmpty()) {
            Map<String, Double> before = values();
            wishes.forEach((name, value) -> declared.computeIfPresent(name, (same, number) -> number.withValue(value)));
            renewFields(robot, before);
        }
        publish(viewer, !wishes.isEmpty());
    }

    private Map<String, Double> wishes(TelemetryPublisher viewer) {
        Map<String, Double> wishes = new HashMap<>();
        for (String name : declared.keySet()) {
            viewer.wish(name).ifPresent(value -> wishes.put(name, value));
        }
        return wishes;
    }

    /** Fields got their values when the robot was made: what two robots made with the old and the new numbers differ in is changed. */
    private void renewFields(Agent robot, Map<String, Double> before) {
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
                    () ->
                            "The numbers of the robot's fields cannot follow their sliders, since no other robot can be made by "
                                    + robot.getClass().getSimpleName()
                                    + "(). Ask for number(...) in think(), where it always has the value of its slider.");
        }
    }

    /** Pages come and go without a word, so the numbers are published again and again. */
    private void publish(TelemetryPublisher viewer, boolean changed) {
        cyclesUntilPublished--;
        if (changed || cyclesUntilPublished < 0) {
            cyclesUntilPublished = CYCLES_UNTIL_PUBLISHED_AGAIN;
            for (TunableNumber number : declared.values()) {
                viewer.declare(new DeclaredNumber(
                        number.name(), number.usual(), number.least(), number.most(), number.value()));
            }
        }
    }

    private Map<String, Double> values() {
        Map<String, Double> values = new HashMap<>();
        declared.forEach((name, number) -> values.put(name, number.value()));
        return values;
    }

    /** Reports names in the file that the program does not have, once all of its numbers are declared. */
    void reportUnknown() {
        for (String name : wanted().keySet()) {
            if (!declared.containsKey(name)) {
                diagnostics.reportAt(
                        "",
                        "number " + name,
                        () -> file + " has a number \"" + name + "\", but the program declares none of this name."
                                + Spelling.question(name, declared.keySet()) + " It has " + declared.keySet() + ".");
            }
        }
    }

    /** The file is read when the first number is declared, so a program without numbers needs none. */
    private Map<String, Double> wanted() {
        Map<String, Double> values = wanted.orElseGet(() -> read(file, diagnostics));
        wanted = Optional.of(values);
        return values;
    }

    private double within(String name, double value, double usual, double least, double most) {
        double taken = Double.isNaN(value) ? usual : Math.max(least, Math.min(most, value));
        if (taken != value) {
            diagnostics.reportAt(
                    "",
                    "number " + name,
                    () -> name + " = " + value + " in " + file + " is not between " + least + " and " + most + "; "
                            + taken + " is taken.");
        }
        return taken;
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
                                                    + " is no number; the usual one is taken.")));
        } catch (IOException unreadable) {
            diagnostics.reportAt("", "numbers", () -> unreadable.getMessage() + " The usual numbers are taken.");
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

package org.robonewbie.workshop.motion;

import com.google.gson.GsonBuilder;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.nao.model.RobotType;

/**
 * Measures all shipped motions in the simulator and prints a table of success rates and mean values.
 *
 * <pre>{@code
 * new MotionMeasurement(20, 1, "", RobotType.TYPE_0, System.out).run(Optional.empty());
 * }</pre>
 */
public final class MotionMeasurement {

    private final int seeds;
    private final PrintStream out;
    private final long firstSeed;
    private final String part;
    private final RobotType type;
    private final List<MotionCheck> more = new ArrayList<>();

    /**
     * Creates a measurement.
     *
     * @param seeds number of trials per motion, at least 1
     * @param firstSeed seed of the first trial of each motion
     * @param part substring of the names of the motions to measure; empty for all
     * @param type robot type; for types other than 0, walks and falls are measured only in a full simulator
     * @param out destination of the table
     */
    public MotionMeasurement(int seeds, long firstSeed, String part, RobotType type, PrintStream out) {
        if (seeds < 1) {
            throw new IllegalArgumentException("Cannot measure with " + seeds + " seeds. Use at least 1.");
        }
        this.seeds = seeds;
        this.firstSeed = firstSeed;
        this.part = part;
        this.type = type;
        this.out = out;
    }

    /**
     * Adds checks after those of the motions.
     *
     * @param checks additional checks
     * @return this measurement
     */
    public MotionMeasurement with(List<MotionCheck> checks) {
        more.addAll(checks);
        return this;
    }

    /** {@return all checks of robot type 0 in the order of the table} */
    public static List<MotionCheck> checks() {
        return checks(RobotType.TYPE_0);
    }

    private static List<MotionCheck> checks(RobotType type) {
        Stream<List<MotionCheck>> walks =
                type == RobotType.TYPE_0 ? Stream.of(WalkChecks.all(), EngineChecks.all()) : Stream.empty();
        Stream<List<MotionCheck>> kicks = Stream.of(KickChecks.all(type), new GetUpChecks(type).all());
        Stream<List<MotionCheck>> falls = type == RobotType.TYPE_0 ? Stream.of(FallChecks.all()) : Stream.empty();
        Stream<List<MotionCheck>> served = Stream.of(ServerChecks.all(type), SkillChecks.all(type));
        return Stream.of(walks, kicks, falls, served)
                .flatMap(checks -> checks)
                .flatMap(List::stream)
                .toList();
    }

    /**
     * Runs all checks and prints each line as soon as it is available.
     *
     * @param json file for the results; empty for none
     * @return the results in the order of the table
     * @throws IOException if the file cannot be written
     */
    public List<CheckResult> run(Optional<Path> json) throws IOException {
        List<CheckResult> results = new ArrayList<>();
        List<MotionCheck> checks = Stream.concat(checks(type).stream(), more.stream())
                .filter(check -> check.name().contains(part))
                .toList();
        if (checks.isEmpty()) {
            throw new IllegalArgumentException("No motion name contains \"" + part + "\".");
        }
        out.printf("%-8s%-28s %9s %9s  %s%n", "", "motion", "successes", "mean", "unit");
        for (MotionCheck check : checks) {
            CheckResult result = CheckResult.of(check, firstSeed, seeds);
            results.add(result);
            out.printf("%-8s%s%n", results.size() + "/" + checks.size(), line(result));
            out.printf("%-10sstart: %s; success: %s%n", "", check.start(), check.rule());
        }
        if (json.isPresent()) {
            write(json.get(), results);
        }
        return results;
    }

    private static String line(CheckResult result) {
        MotionCheck check = result.check();
        return String.format(
                Locale.ROOT,
                "%-28s %4d/%-4d %9.3f  %s",
                check.name(),
                result.successes(),
                result.outcomes().size(),
                result.mean(),
                check.unit());
    }

    private static void write(Path file, List<CheckResult> results) throws IOException {
        List<Row> rows = results.stream().map(Row::of).toList();
        String text = new GsonBuilder().setPrettyPrinting().create().toJson(Map.of("motions", rows)) + "\n";
        AtomicFile.write(file, text);
    }

    /** JSON object for one check. */
    private record Row(String name, int trials, int successes, double mean, String unit, String start, String rule) {

        static Row of(CheckResult result) {
            MotionCheck check = result.check();
            return new Row(
                    check.name(),
                    result.outcomes().size(),
                    result.successes(),
                    result.mean(),
                    check.unit(),
                    check.start(),
                    check.rule());
        }
    }
}

package org.robonewbie.workshop.motion;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.file.MotionFiles;

/**
 * Writes the measured success rates into the headers of the motion files.
 *
 * <pre>{@code
 * java org.robonewbie.workshop.motion.MeasuredHeaders core/robot/src/main/resources/motions
 * }</pre>
 */
public final class MeasuredHeaders {

    private static final int SEEDS = 20;

    private MeasuredHeaders() {}

    /**
     * Measures all shipped motions and writes the results into their files.
     *
     * @param arguments directory of the files
     * @throws IOException if a file cannot be read or written
     */
    public static void main(String[] arguments) throws IOException {
        if (arguments.length != 1) {
            System.err.println("Pass the directory of the motion files.");
            System.exit(2);
        }
        MotionMeasurement measurement = new MotionMeasurement(SEEDS, 1, "", RobotType.TYPE_0, System.out);
        write(measurement.run(Optional.empty()), Path.of(arguments[0]));
    }

    /**
     * Writes results into files.
     *
     * @param results the results; those without a file are ignored
     * @param directory directory of the files {@code NAME.txt}
     * @throws IOException if a file cannot be read or written
     */
    public static void write(List<CheckResult> results, Path directory) throws IOException {
        for (CheckResult result : results) {
            Path path = directory.resolve(result.check().name() + ".txt");
            if (Files.exists(path)) {
                MotionFiles.save(MotionFiles.load(path).withProperty("measured", text(result)), path);
            }
        }
    }

    private static String text(CheckResult result) {
        return String.format(
                Locale.ROOT,
                "%d of %d trials, mean %.3f %s; success: %s",
                result.successes(),
                result.outcomes().size(),
                result.mean(),
                result.check().unit(),
                result.check().rule());
    }
}

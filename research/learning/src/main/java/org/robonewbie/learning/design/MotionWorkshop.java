package org.robonewbie.learning.design;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import org.robonewbie.learning.search.Search;
import org.robonewbie.learning.search.SearchPlan;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.file.MotionFiles;

/**
 * Recreates motions of the library: searches as their designs say and writes the files. The result is the same each time.
 *
 * <pre>{@code
 * java org.robonewbie.learning.design.MotionWorkshop walk-forward core/nao/src/main/resources/motions
 * }</pre>
 */
public final class MotionWorkshop {

    private MotionWorkshop() {}

    /**
     * Creates the motions of one design.
     *
     * @param arguments name of the design and the directory for the files
     * @throws IOException if a file cannot be written
     */
    public static void main(String[] arguments) throws IOException {
        if (arguments.length != 2) {
            System.err.println("Give the name of a design and a directory. Designs: " + Designs.names());
            System.exit(2);
        }
        make(arguments[0], Path.of(arguments[1]));
    }

    /**
     * Creates the motions of one design; after each generation the files hold what has been found so far.
     *
     * @param name name of the design
     * @param directory where the files are written
     * @throws IOException if a file cannot be written
     */
    public static void make(String name, Path directory) throws IOException {
        MotionDesign design = Designs.named(name);
        Files.createDirectories(directory);
        double[] found = new Search(design.plan(), design).run(design.start(), progress -> {
            System.out.println(progress);
            write(name, design, progress.mean(), directory);
        });
        write(name, design, found, directory);
    }

    private static void write(String name, MotionDesign design, double[] found, Path directory) {
        for (DescribedMotion described : design.motions(found)) {
            MotionFile file = MotionFile.of(described.motion())
                    .withColumns()
                    .withProperty("coordinates", text(found))
                    .withProperty("made by", "robonewbie optimise " + name + " --again" + seed(design.plan()))
                    .withProperty("end", described.end())
                    .withProperty("start", described.start())
                    .withProperty("does", described.does());
            for (Map.Entry<String, String> line : described.more().entrySet()) {
                file = file.withProperty(line.getKey(), line.getValue());
            }
            save(file, directory.resolve(file.name()));
        }
    }

    private static String seed(SearchPlan plan) {
        return plan.generations() == 0 ? "" : "; seed " + plan.seed() + ", " + plan.generations() + " generations";
    }

    private static void save(MotionFile file, Path path) {
        try {
            MotionFiles.save(file, path);
        } catch (IOException e) {
            throw new UncheckedIOException("Cannot write " + path + ".", e);
        }
    }

    private static String text(double[] coordinates) {
        return Arrays.stream(coordinates)
                .mapToObj(x -> String.format(Locale.ROOT, "%.3f", x))
                .collect(Collectors.joining(" "));
    }
}

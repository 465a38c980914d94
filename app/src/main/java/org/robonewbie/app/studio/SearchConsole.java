package org.robonewbie.app.studio;

import java.io.PrintStream;
import java.nio.file.Path;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.robonewbie.learning.optimise.Evaluation;
import org.robonewbie.learning.optimise.Generation;
import org.robonewbie.learning.optimise.OptimisationListener;
import org.robonewbie.learning.optimise.OptimisationResult;
import org.robonewbie.trial.batch.BatchProgress;

/** Prints the progress of an optimisation. Generations that were run before an interruption are not printed again. */
public final class SearchConsole implements OptimisationListener {

    private final PrintStream out;
    private final String unit;
    private final Path file;
    private @Nullable BatchProgress progress;

    /**
     * Creates a console.
     *
     * @param out the output
     * @param unit unit of the values
     * @param file file for the best result
     */
    public SearchConsole(PrintStream out, String unit, Path file) {
        this.out = out;
        this.unit = unit;
        this.file = file;
    }

    @Override
    public void begins(Evaluation before) {
        out.printf(Locale.ROOT, "start: %.3f %s%n", before.value(), unit);
    }

    @Override
    public void reached(Generation generation) {
        if (generation.isRemembered()) {
            return;
        }
        BatchProgress bar = progress;
        if (bar == null) {
            progress = BatchProgress.of("generations", generation.of(), generation.number());
            out.println(line(generation));
        } else {
            bar.print(out::println, line(generation));
            bar.advance(false);
        }
    }

    @Override
    public void ends(OptimisationResult result) {
        if (progress != null) {
            progress.close();
        }
        out.println("before: " + result.words(result.before()));
        out.println("after:  " + result.words(result.after()));
        out.println(outcome(result, file));
        if (result.isBetter()) {
            out.print(result.advice());
        }
    }

    static String outcome(OptimisationResult result, Path file) {
        return result.isBetter()
                ? "The result was written to " + file + "."
                : "No improvement was found, so nothing was written. More --generations or another --seed may help.";
    }

    private String line(Generation generation) {
        long seconds = Math.round(generation.pace().secondsLeft());
        return String.format(
                Locale.ROOT,
                "generation %d/%d: best %.3f %s, mean %.3f %s, %.0f%% succeed, %d:%02d left",
                generation.number(),
                generation.of(),
                generation.score().best(),
                unit,
                generation.score().mean(),
                unit,
                100 * generation.score().success(),
                seconds / 60,
                seconds % 60);
    }
}

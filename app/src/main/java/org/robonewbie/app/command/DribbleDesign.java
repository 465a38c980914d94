package org.robonewbie.app.command;

import java.io.IOException;
import java.nio.file.Path;
import org.robonewbie.learning.search.CostFunction;
import org.robonewbie.learning.search.Search;
import org.robonewbie.learning.search.SearchFile;
import org.robonewbie.learning.search.SearchPlan;
import org.robonewbie.team.skill.CloseDribble;
import org.robonewbie.team.skill.CloseDribbleNumbers;

/**
 * The search for the numbers of {@link CloseDribble}: those of its walk and those of its touches together.
 *
 * <p>Three rounds of active CMA-ES have led to the shipped ones, on 25 November 2026 at commit 020d3efe, on a third of a core, while this class
 * was written. First the walk alone, from {@code WalkStyle.FAST}, so that its feet are slow where they meet a ball: seed 1, 75 generations of 14,
 * in 3 minutes. Then the touches alone: seed 1, 45 generations of 10, in 9 minutes. Then all together, as here: seed 5, 29 generations of 12
 * with 6 trials each, in 16 minutes. The largest speed, its change and the speed of a touch were set by hand after that.
 *
 * <pre>
 * java -cp robonewbie.jar org.robonewbie.app.command.DribbleDesign coordinates.txt
 * </pre>
 *
 * <p>goes on from there, with the same result each time.
 */
public final class DribbleDesign implements CostFunction {

    private static final SearchPlan PLAN = new SearchPlan(5, 0.2, 12, 60, 6, 2);

    /** Prepares the search. */
    DribbleDesign() {}

    /**
     * Goes on with the search from a file, or from the shipped numbers, and writes what it finds into that file after each generation.
     *
     * @param arguments the file with the coordinates
     * @throws IOException if the file cannot be read or written
     */
    public static void main(String[] arguments) throws IOException {
        SearchFile.goOn(
                Path.of(arguments[0]), CloseDribbleNumbers.coordinates(), new Search(PLAN, new DribbleDesign()));
    }

    @Override
    public double cost(double[] x, long seed) {
        return DribbleTrial.direct(CloseDribbleNumbers.of(x), seed).cost();
    }
}

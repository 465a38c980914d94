package org.robonewbie.app.studio;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.IntStream;
import org.robonewbie.learning.optimise.Evaluation;
import org.robonewbie.learning.optimise.Generation;
import org.robonewbie.learning.optimise.MotionParametrization;
import org.robonewbie.learning.optimise.Objective;
import org.robonewbie.learning.optimise.Optimisation;
import org.robonewbie.learning.optimise.OptimisationListener;
import org.robonewbie.learning.optimise.OptimisationPlan;
import org.robonewbie.learning.optimise.OptimisationResult;
import org.robonewbie.learning.optimise.Parameter;
import org.robonewbie.learning.optimise.Parametrization;
import org.robonewbie.studio.StudioFolders;
import org.robonewbie.studio.search.SearchFeed;
import org.robonewbie.studio.search.SearchNumber;
import org.robonewbie.studio.search.SearchRound;
import org.robonewbie.studio.search.SearchTask;

/** Studio that shows the progress of an optimisation and opens the current motion in the motion editor. */
public final class SearchStudio implements OptimisationListener, AutoCloseable {

    private final Parametrization subject;
    private final List<Parameter> start;
    private final SearchFeed board;
    private final Path fileSoFar;
    private final Path file;
    private final boolean withBrowser;
    private final BoardStudio studio;

    private SearchStudio(
            Parametrization subject, SearchFeed board, Path fileSoFar, Path file, SearchStudioOptions options)
            throws IOException {
        this.subject = subject;
        this.start = subject.numbers(new double[subject.dimension()]);
        this.board = board;
        this.fileSoFar = fileSoFar;
        this.file = file;
        this.withBrowser = !options.isWithoutBrowser;
        StudioFolders folders = new StudioFolders(
                Optional.ofNullable(file.toAbsolutePath().getParent()).orElse(Path.of("")), Optional.empty());
        this.studio = BoardStudio.open(board, options.port, folders);
    }

    /**
     * Opens the studio with an empty pitch; the trials run in separate worlds.
     *
     * @param options display options
     * @param subject what is optimised
     * @param objective the measure to improve
     * @param plan size of the search
     * @param optimisation the search
     * @param file file for the best result
     * @return the open studio
     */
    public static SearchStudio open(
            SearchStudioOptions options,
            Parametrization subject,
            Objective objective,
            OptimisationPlan plan,
            Optimisation optimisation,
            Path file)
            throws IOException {
        String method = String.format(
                Locale.ROOT,
                "%d generations of %d candidates with %d trials each",
                plan.generations(),
                plan.population(),
                plan.trials());
        SearchFeed board = new SearchFeed(new SearchTask(
                subject.name(),
                objective.label(),
                objective.unit(),
                objective.isLargerBetter(),
                plan.generations(),
                method));
        return new SearchStudio(subject, board, optimisation.fileSoFar(), file, options);
    }

    /** {@return the text to print: a one-time URL, and how to get another one} */
    public String invitation() {
        return studio.invitation();
    }

    /** Opens the page in the browser, unless the options disable it. */
    public void showBrowser() {
        if (withBrowser) {
            studio.showBrowser();
        }
    }

    /**
     * Adds another listener.
     *
     * @param other called after this one
     * @return a listener that calls both
     */
    public OptimisationListener and(OptimisationListener other) {
        return new Both(this, other);
    }

    /**
     * Waits until no page is open.
     *
     * @throws InterruptedException if the thread is interrupted while it waits
     */
    public void awaitUnwatched() throws InterruptedException {
        studio.awaitUnwatched();
    }

    @Override
    public void begins(Evaluation before) {
        board.begins(before.value());
    }

    @Override
    public void reached(Generation generation) {
        Generation.Score score = generation.score();
        SearchRound round = new SearchRound(
                generation.number(),
                score.best(),
                score.mean(),
                score.success(),
                generation.distribution().step(),
                generation.pace().trialsPerSecond(),
                generation.pace().secondsLeft());
        board.reached(round, numbers(generation), generation.isRemembered() ? "" : place(fileSoFar));
    }

    @Override
    public void ends(OptimisationResult result) {
        String words = result.words(result.after()) + ". " + SearchConsole.outcome(result, file);
        board.ends(result.after().value(), words, result.isBetter() ? place(file) : "");
    }

    @Override
    public void close() {
        studio.close();
    }

    private List<SearchNumber> numbers(Generation generation) {
        List<Double> middle = generation.distribution().middle();
        List<Double> spread = generation.distribution().spread();
        List<Parameter> now =
                subject.numbers(middle.stream().mapToDouble(Double::doubleValue).toArray());
        return IntStream.range(0, now.size())
                .mapToObj(i -> {
                    Parameter number = now.get(i);
                    double size = number.coordinateSize();
                    return new SearchNumber(
                            number.name(),
                            number.unit(),
                            start.get(i).value(),
                            number.value(),
                            size * spread.get(i),
                            size);
                })
                .toList();
    }

    private String place(Path motion) {
        return subject instanceof MotionParametrization && motion.toString().endsWith(".txt")
                ? OpenedFile.motionPlace(motion)
                : "";
    }

    private record Both(OptimisationListener one, OptimisationListener other) implements OptimisationListener {

        @Override
        public void begins(Evaluation before) {
            one.begins(before);
            other.begins(before);
        }

        @Override
        public void reached(Generation generation) {
            one.reached(generation);
            other.reached(generation);
        }

        @Override
        public void ends(OptimisationResult result) {
            one.ends(result);
            other.ends(result);
        }
    }
}

package org.robonewbie.learning.policy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.policy.PolicyText;
import org.robonewbie.nao.file.AtomicFile;

/**
 * Learns a task by an {@link EvolutionStrategy}, lesson by lesson. After each generation it writes the policy so far, a line of
 * the curve as CSV, and all that is needed to go on.
 *
 * <pre>{@code
 * PolicyTraining training = new PolicyTraining(WalkCourse.WALK, plan, Path.of("walk.policy"), List.of());
 * training.run(training.begin(), line -> System.out.println(line));
 * }</pre>
 *
 * @param course what is learned
 * @param plan how
 * @param output where the policy goes; curve and checkpoint are written beside it
 * @param history how the policy was learned with which it starts, in lines for people; none if it begins with the engine
 */
public record PolicyTraining(Course course, TrainingPlan plan, Path output, List<String> history) {

    private static final String CURVE = "generation," + LessonFigures.columns() + "\n";

    /** Copies the list. */
    public PolicyTraining {
        history = List.copyOf(history);
    }

    /** {@return the curve, a CSV file beside the policy} */
    public Path curve() {
        return beside(".csv");
    }

    /** {@return all that is needed to go on, a file beside the policy} */
    public Path checkpoint() {
        return beside(".checkpoint");
    }

    private Path beside(String ending) {
        return output.resolveSibling(output.getFileName() + ending);
    }

    /** {@return where a training starts that knows nothing} */
    public EvolutionStrategy.State begin() {
        return EvolutionStrategy.State.begin(course.start(plan.seed()), course.units());
    }

    /**
     * Starts from a policy.
     *
     * @param policy what was learned before, of the same task
     * @return where the training starts
     */
    public EvolutionStrategy.State begin(Policy policy) {
        return EvolutionStrategy.State.begin(course.start(policy), course.units());
    }

    /**
     * Goes on where a training was interrupted.
     *
     * @return where it was
     * @throws IOException if there is no checkpoint or it cannot be read
     * @throws IllegalArgumentException if it belongs to another training
     */
    public EvolutionStrategy.State resume() throws IOException {
        return TrainingState.read(checkpoint(), question(), course.units()).state();
    }

    private String question() {
        return course.task() + " " + course.words(plan);
    }

    /**
     * Learns until the plan is done.
     *
     * @param start where the training is
     * @param progress gets a line after each generation
     * @return what was learned
     * @throws IOException if a file cannot be written
     */
    public Policy run(EvolutionStrategy.State start, Consumer<String> progress) throws IOException {
        EvolutionStrategy.State state = start;
        beginCurve(start.generation());
        try (LessonRooms<Classroom> rooms = rooms(course, plan)) {
            while (state.generation() < plan.generations()) {
                List<LessonFigures> figures = generation(rooms, state);
                state = plan.strategy()
                        .tell(
                                state,
                                figures.stream()
                                        .mapToDouble(LessonFigures::reward)
                                        .toArray());
                keep(state, figures, progress);
            }
        }
        return policy(state);
    }

    /** Keeps what belongs to the generations that are known: a program that was killed may have written one line more. */
    private void beginCurve(int generations) throws IOException {
        List<String> lines = generations == 0 ? List.of() : Files.readAllLines(curve());
        String known = lines.stream()
                .skip(1)
                .limit(generations)
                .map(line -> line + "\n")
                .collect(Collectors.joining());
        AtomicFile.write(curve(), CURVE + known);
    }

    /** Opens as many worlds as lessons are given at the same time. */
    static LessonRooms<Classroom> rooms(Course course, TrainingPlan plan) {
        return new LessonRooms<>(plan.threads(), () -> course.open(plan), Classroom::close);
    }

    private List<LessonFigures> generation(LessonRooms<Classroom> rooms, EvolutionStrategy.State state) {
        EvolutionStrategy strategy = plan.strategy();
        List<double[]> candidates = strategy.ask(state);
        return rooms.give(IntStream.range(0, candidates.size())
                .mapToObj(i -> (Function<Classroom, LessonFigures>)
                        room -> room.give(strategy.seedOfTrial(state, i), candidates.get(i)))
                .toList());
    }

    private void keep(EvolutionStrategy.State state, List<LessonFigures> figures, Consumer<String> progress)
            throws IOException {
        LessonFigures all = new LessonFigures();
        figures.forEach(all::add);
        String line = state.generation() + "," + all.row() + "\n";
        Files.writeString(curve(), line, StandardCharsets.UTF_8, StandardOpenOption.APPEND);
        AtomicFile.write(output, PolicyText.format(policy(state)));
        new TrainingState(question(), state).write(checkpoint());
        progress.accept(String.format(Locale.ROOT, "%4d/%d: %s", state.generation(), plan.generations(), all));
    }

    private Policy policy(EvolutionStrategy.State state) {
        String last = "learned by: robonewbie learn " + question() + " --generations " + state.generation();
        return course.policy(
                plan, Stream.concat(history.stream(), Stream.of(last)).toList(), state.mean());
    }
}

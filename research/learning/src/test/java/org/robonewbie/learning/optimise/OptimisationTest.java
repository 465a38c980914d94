package org.robonewbie.learning.optimise;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class OptimisationTest {

    private static final Objective OBJECTIVE = NamedObjective.named("kick-distance");

    @TempDir
    private Path folder;

    @Test
    void makesItsSubjectBetterAndSaysHow() throws IOException {
        Path file = folder.resolve("hill.txt");

        OptimisationResult result =
                new Optimisation(new Hill(), OBJECTIVE, plan(30, 2), file).run(false, new ArrayList<>()::add);

        assertThat(result.after().value()).isGreaterThan(result.before().value() + 1);
        assertThat(Files.readString(file))
                .contains("made by: robonewbie optimise hill --objective kick-distance --generations 30"
                        + " --population 8 --seed 5 --seeds 2 --step 0.5")
                .contains("before: kick-distance ")
                .contains("after: kick-distance ");
    }

    @Test
    void doesNotDependOnTheNumberOfThreads() throws IOException {
        Path one = folder.resolve("one.txt");
        Path four = folder.resolve("four.txt");

        new Optimisation(new Hill(), OBJECTIVE, plan(10, 1), one).run(false, new ArrayList<>()::add);
        new Optimisation(new Hill(), OBJECTIVE, plan(10, 4), four).run(false, new ArrayList<>()::add);

        assertThat(four).hasSameTextualContentAs(one);
    }

    @Test
    void goesOnAsIfItHadNeverBeenInterrupted() throws IOException {
        Path whole = folder.resolve("whole.txt");
        Path broken = folder.resolve("broken.txt");
        List<Generation> known = new ArrayList<>();
        List<Generation> later = new ArrayList<>();
        new Optimisation(new Hill(), OBJECTIVE, plan(12, 2), whole).run(false, new ArrayList<>()::add);
        var interrupted = new Optimisation(new Hill(), OBJECTIVE, plan(12, 2), broken);

        assertThatThrownBy(() -> interrupted.run(false, generation -> {
                    known.add(generation);
                    if (generation.number() == 5) {
                        throw new IllegalStateException("interrupted");
                    }
                }))
                .hasMessage("interrupted");
        interrupted.run(true, later::add);

        assertThat(later).hasSize(12);
        assertThat(later).filteredOn(Generation::isRemembered).hasSize(5);
        assertThat(later.subList(0, 5)).zipSatisfy(known, (again, first) -> {
            assertThat(again.score()).isEqualTo(first.score());
            assertThat(again.distribution()).isEqualTo(first.distribution());
        });
        assertThat(broken).hasSameTextualContentAs(whole);
    }

    @Test
    void canBeLookedAtWhileItGoesOn() throws IOException {
        var optimisation = new Optimisation(new Hill(), OBJECTIVE, plan(2, 1), folder.resolve("hill.txt"));
        List<String> seen = new ArrayList<>();

        optimisation.run(false, generation -> seen.add(content(optimisation.fileSoFar())));

        assertThat(optimisation.fileSoFar()).hasFileName("hill-so-far.txt").doesNotExist();
        assertThat(seen.get(1)).contains("so far: generation 2");
    }

    @Test
    void tellsHowFarItsCloudSpreads() throws IOException {
        List<Generation> generations = new ArrayList<>();

        new Optimisation(new Hill(), OBJECTIVE, plan(40, 1), folder.resolve("hill.txt")).run(false, generations::add);

        SearchDistribution first = generations.get(0).distribution();
        SearchDistribution last = generations.get(39).distribution();
        assertThat(first.spread()).allSatisfy(spread -> assertThat(spread).isBetween(0.2, 1.0));
        assertThat(last.spread()).allSatisfy(spread -> assertThat(spread).isLessThan(0.2));
        assertThat(last.middle()).allSatisfy(x -> assertThat(x).isCloseTo(1, within(0.3)));
    }

    @Test
    void refusesToGoOnWithSomethingElse() throws IOException {
        Path file = folder.resolve("hill.txt");
        new Optimisation(new Hill(), OBJECTIVE, plan(2, 1), file).run(false, new ArrayList<>()::add);
        var other = new Optimisation(new Hill(), NamedObjective.named("energy"), plan(2, 1), file);

        assertThatThrownBy(() -> other.run(true, new ArrayList<>()::add))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("hill.txt.checkpoint belongs to another run")
                .hasMessageContaining("delete the file to start over");
    }

    @Test
    void refusesToGoOnWithNothing() {
        var fresh = new Optimisation(new Hill(), OBJECTIVE, plan(2, 1), folder.resolve("hill.txt"));

        assertThatThrownBy(() -> fresh.run(true, new ArrayList<>()::add))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("There is nothing to resume")
                .hasMessageContaining("does not exist. Omit --resume to start a new search.");
    }

    @Test
    void refusesACheckpointThatCannotBeRead() throws IOException {
        Path file = folder.resolve("hill.txt");
        var optimisation = new Optimisation(new Hill(), OBJECTIVE, plan(2, 1), file);
        optimisation.run(false, new ArrayList<>()::add);
        Path checkpoint = optimisation.checkpointFile();
        Files.writeString(checkpoint, Files.readAllLines(checkpoint).get(0) + "\n1.0 many 2.0 | 1.0 1.0 1.0\n");

        assertThatThrownBy(() -> optimisation.run(true, new ArrayList<>()::add))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("is damaged at \"1.0 many 2.0 | 1.0 1.0 1.0\"");
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void refusesACheckpointWithAnotherDigit(int generation) throws IOException {
        var optimisation = new Optimisation(new Hill(), OBJECTIVE, plan(2, 1), folder.resolve("hill.txt"));
        optimisation.run(false, new ArrayList<>()::add);
        Path checkpoint = optimisation.checkpointFile();
        List<String> lines = new ArrayList<>(Files.readAllLines(checkpoint));
        String line = lines.get(generation);
        char digit = line.charAt(0) == '9' ? '8' : '9';
        lines.set(generation, digit + line.substring(1));
        Files.write(checkpoint, lines);

        assertThatThrownBy(() -> optimisation.run(true, new ArrayList<>()::add))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("hill.txt.checkpoint is damaged: the checksum of \"" + digit)
                .hasMessageContaining("Omit --resume");
    }

    @Test
    void goesOnFromACheckpointWithoutChecksums() throws IOException {
        Path file = folder.resolve("hill.txt");
        OptimisationResult expected =
                new Optimisation(new Hill(), OBJECTIVE, plan(4, 1), file).run(false, new ArrayList<>()::add);
        var optimisation = new Optimisation(new Hill(), OBJECTIVE, plan(4, 1), file);
        List<String> whole = Files.readAllLines(optimisation.checkpointFile());
        Files.write(
                optimisation.checkpointFile(),
                whole.stream()
                        .limit(3)
                        .map(line -> line.replaceFirst(" \\| [0-9a-f]{8}$", ""))
                        .toList());

        OptimisationResult resumed = optimisation.run(true, new ArrayList<>()::add);

        assertThat(resumed).isEqualTo(expected);
        assertThat(Files.readAllLines(optimisation.checkpointFile()).subList(3, 5))
                .isEqualTo(whole.subList(3, 5));
    }

    @Test
    void writesNothingThatIsNotBetter() throws IOException {
        Path file = folder.resolve("top.txt");

        OptimisationResult result =
                new Optimisation(new Hill(0), OBJECTIVE, plan(3, 1), file).run(false, new ArrayList<>()::add);

        assertThat(result.isBetter()).isFalse();
        assertThat(file).doesNotExist();
    }

    @Test
    void refusesPlansThatCannotWork() {
        assertThatThrownBy(() -> new OptimisationPlan(1, 1, 3, 1, 1, 1, false))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("--population must be at least 4, not 3.");
        assertThatThrownBy(() -> new OptimisationPlan(1, 1, 4, 1, 0, 1, false))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("--step must be above 0 and at most 10, not 0.0.");
    }

    private static String content(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static OptimisationPlan plan(int generations, int threads) {
        return new OptimisationPlan(5, generations, 8, 2, 0.5, threads, false);
    }
}

package org.robonewbie.learning.series;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.trial.batch.BatchProgress;
import org.robonewbie.trial.batch.BatchRunner;
import org.robonewbie.trial.batch.ThreadRunner;

class ExperimentRunTest {

    @TempDir
    private Path folder;

    @Test
    void tableIsTheSameForAnyNumberOfThreads() throws IOException {
        ExperimentPlan plan = plan("experiment=" + PushExperiment.class.getName(), "trials=12", "newtons=5, 150");

        String one = table(plan, 1).csv();

        assertThat(table(plan, 3).csv()).isEqualTo(one);
        assertThat(one).startsWith("trial,seed,newtons,side_degrees,fallen,largest_tilt_degrees\n0,");
        assertThat(one.lines()).hasSize(13);
    }

    @Test
    void strongPushesThrowRobotsAndWeakOnesDoNot() throws IOException {
        ExperimentPlan plan = plan("experiment=" + PushExperiment.class.getName(), "trials=8", "newtons=5,150");

        ResultTable table = table(plan, 2);

        for (int i = 0; i < 8; i++) {
            assertThat(table.measured().get(i)[1]).isEqualTo(i % 2);
        }
    }

    @Test
    void parametersGoThroughAllCombinations() throws IOException {
        ExperimentPlan plan = plan("experiment=x # a comment", "", "trials=5", "seed=7", "a=1,2", "b=10,20");

        assertThat(plan.all().stream().map(PlannedTrial::parameters).map(Map::toString))
                .containsExactly(
                        "{a=1.0, b=10.0}", "{a=2.0, b=10.0}", "{a=1.0, b=20.0}", "{a=2.0, b=20.0}", "{a=1.0, b=10.0}");
        assertThat(plan.all().stream().map(PlannedTrial::seed)).doesNotHaveDuplicates();
        assertThat(plan.all()).isEqualTo(plan.all());
    }

    @Test
    void parametersMayBeTexts() throws IOException {
        ExperimentPlan plan =
                plan("experiment=" + Wordy.class.getName(), "trials=4", "word=\"a, b\", \"cd\"", "times=1,2");

        assertThat(table(plan, 1).csv().lines().map(line -> line.replaceFirst(",\\d+,", ",")))
                .containsExactly(
                        "trial,seed,times,word,length",
                        "0,1.0,\"a, b\",4.0",
                        "1,2.0,\"a, b\",8.0",
                        "2,1.0,cd,2.0",
                        "3,2.0,cd,4.0");
        assertThatThrownBy(() -> plan.requireKnown(List.of("times", "words")))
                .hasMessageContaining("\"word\"")
                .hasMessageContaining("Did you mean words?");
        assertThatThrownBy(() -> Experiment.of(Broken.class.getName()).run(Map.of(), Map.of("word", "x"), 1))
                .hasMessageContaining("takes numbers only");
    }

    @Test
    void misspeltNamesOfAPlanAreRefusedWithTheNearest() throws IOException {
        ExperimentPlan plan = plan("experiment=x", "sede=1", "newtons=20");

        assertThatThrownBy(() -> plan.requireKnown(List.of("newtons"))).hasMessageContaining("Did you mean seed?");
        assertThatThrownBy(() -> plan("experment=x"))
                .hasMessageContaining("line 1")
                .hasMessageContaining("Did you mean experiment?");
        assertThatThrownBy(() -> plan("experiment=x", "trials=many"))
                .hasMessageContaining("\"trials=many\" is not a valid line. Write");
    }

    @Test
    void nameThatIsGivenTwiceIsRefused() {
        assertThatThrownBy(() -> plan("experiment=x", "newtons=20", "newtons=40"))
                .hasMessageContaining("line 3")
                .hasMessageContaining("\"newtons\" is set twice");
    }

    @Test
    void trialThatFailsOnceIsTriedAgain() throws IOException {
        ExperimentPlan plan = plan("experiment=" + Shaky.class.getName(), "trials=20");

        ResultTable table = table(plan, 2);

        assertThat(table.measured()).hasSize(20).allMatch(row -> row[0] >= 0);
        assertThat(table.failures()).isEmpty();
    }

    @Test
    void trialThatFailsAlwaysIsNamed() throws IOException {
        ExperimentPlan plan = plan("experiment=" + Broken.class.getName(), "trials=2", "seed=3", "a=4");

        assertThat(table(plan, 1).failures().get(0))
                .matches(
                        "Trial 0 \\(seed \\d+, \\{a=4.0}\\) failed 3 times: .*run\\(\\) returned 0 values for 1 columns");
    }

    @Test
    void trialWhoseLineIsDamagedIsRunAgain() throws IOException {
        ExperimentPlan plan = plan("experiment=" + PushExperiment.class.getName(), "trials=4", "newtons=20");
        String whole = table(plan, 2).csv();
        Path file = folder.resolve("push.csv.trials");
        String header;
        try (ExperimentRun run = ExperimentRun.open(file, plan)) {
            header = Files.readString(file);
            run.run(new ThreadRunner(1), new BatchProgress("trials", 4, 0, false, System.err, () -> 0));
        }
        List<String> lines = Files.readAllLines(file);
        Files.writeString(file, header + "0,1.5,many\nx,1.0,2.0\n" + lines.get(3) + "\n3,1.0");

        try (ExperimentRun again = ExperimentRun.open(file, plan)) {
            assertThat(again.missing()).extracting(PlannedTrial::number).containsExactly(0, 1, 3);
        }
        assertThat(table(file, plan, 2).csv()).isEqualTo(whole);
    }

    @Test
    void mistakesInAPlanAreTold() {
        assertThatThrownBy(() -> plan("experiment=x", "newtons=a lot"))
                .hasMessageEndingWith("line 2: \"newtons=a lot\" is not a valid line. "
                        + "Write name=number, or name=number,number,… or name=\"text\" for a parameter.");
        assertThatThrownBy(() -> plan("experiment=x", "agent=\"A\",B"))
                .hasMessageContaining("line 2: \"agent=\"A\",B\" is not a valid line.");
        assertThatThrownBy(() -> plan("experiment=x", "agent=\"A").all()).hasMessageContaining("is not a valid line");
        assertThatThrownBy(() -> plan("trials=3"))
                .hasMessageEndingWith("a plan needs a line experiment=NAME.OF.A.CLASS and trials from 1 to 100000000; "
                        + "this one has \"\" and 3.");
        assertThatThrownBy(() -> Experiment.of("java.lang.String"))
                .hasMessageContaining("There is no experiment \"java.lang.String\".");
    }

    @Test
    void tableIsWrittenAsJsonToo() throws IOException {
        ExperimentPlan plan = plan("experiment=" + Shaky.class.getName(), "trials=2", "a=4");
        Path file = folder.resolve("table.json");

        table(plan, 1).write(file);

        assertThat(Files.readString(file))
                .startsWith("[\n {\n  \"trial\": 0,\n  \"seed\": ")
                .contains("\"a\": 4.0");
    }

    private ExperimentPlan plan(String... lines) throws IOException {
        return ExperimentPlan.read(Files.write(folder.resolve("plan.txt"), List.of(lines)));
    }

    private ResultTable table(ExperimentPlan plan, int threads) throws IOException {
        return table(folder.resolve(threads + ".trials"), plan, threads);
    }

    private static ResultTable table(Path journal, ExperimentPlan plan, int threads) throws IOException {
        try (ExperimentRun run = ExperimentRun.open(journal, plan);
                BatchRunner runner = new ThreadRunner(threads)) {
            run.run(runner, new BatchProgress("trials", plan.trials(), 0, false, System.err, () -> 0));
            return run.table(Experiment.of(plan.experiment()).columns());
        }
    }

    /** Fails in the first attempt of each trial. */
    public static final class Shaky implements Experiment {

        private static final Set<Long> TRIED = ConcurrentHashMap.newKeySet();

        @Override
        public List<String> columns() {
            return List.of("x, \"y\"");
        }

        @Override
        public double[] run(Map<String, Double> parameters, long seed) {
            if (TRIED.add(seed)) {
                throw new IllegalStateException("not yet");
            }
            return new double[] {seed};
        }
    }

    /** Measures its texts. */
    public static final class Wordy implements Experiment {

        @Override
        public List<String> columns() {
            return List.of("length");
        }

        @Override
        public double[] run(Map<String, Double> parameters, long seed) {
            return new double[0];
        }

        @Override
        public double[] run(Map<String, Double> numbers, Map<String, String> texts, long seed) {
            return new double[] {
                numbers.getOrDefault("times", 1.0)
                        * texts.getOrDefault("word", "").length()
            };
        }
    }

    /** Gives too few numbers. */
    public static final class Broken implements Experiment {

        @Override
        public List<String> columns() {
            return List.of("x");
        }

        @Override
        public double[] run(Map<String, Double> parameters, long seed) {
            return new double[0];
        }
    }
}

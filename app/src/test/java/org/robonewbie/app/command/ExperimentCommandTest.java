package org.robonewbie.app.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.app.Printed;
import org.robonewbie.learning.series.Experiment;
import org.robonewbie.learning.series.ExperimentPlan;
import org.robonewbie.learning.series.ExperimentRun;
import org.robonewbie.learning.series.PushExperiment;

class ExperimentCommandTest {

    @TempDir
    private Path folder;

    @Test
    void planBecomesATable() throws IOException {
        Path plan = folder.resolve("push.plan");
        Files.writeString(plan, "experiment=org.robonewbie.learning.series.PushExperiment\ntrials=4\nnewtons=5,150\n");
        Path table = folder.resolve("push.csv");

        int code = RoboNewbieCommand.run("experiment", plan.toString(), "--output", table.toString(), "--threads", "2");

        assertThat(code).isZero();
        assertThat(Files.readAllLines(table))
                .hasSize(5)
                .first()
                .isEqualTo("trial,seed,newtons,side_degrees,fallen,largest_tilt_degrees");
    }

    /** What a kill leaves behind: some lines, not in order, and half of one. */
    @Test
    void experimentThatWasKilledGoesOnAndGivesTheSameTable() throws IOException {
        Path plan = Files.writeString(
                folder.resolve("push.plan"),
                "experiment=org.robonewbie.learning.series.PushExperiment\ntrials=4\nnewtons=5,150\n");
        Path whole = folder.resolve("whole.csv");
        Path broken = folder.resolve("broken.csv");
        RoboNewbieCommand.run("experiment", plan.toString(), "--output", whole.toString());
        ExperimentRun.open(folder.resolve("broken.csv.trials"), ExperimentPlan.read(plan))
                .close();
        Files.writeString(folder.resolve("broken.csv.trials"), "2,1.0,2.0,3.0\n3,0.5,1", StandardOpenOption.APPEND);

        Printed printed = Printed.by("experiment", plan.toString(), "--output", broken.toString());

        assertThat(printed.exitCode()).as(printed.err()).isZero();
        assertThat(printed.err()).contains("1 trials are already done; 3 are left.");
        List<String> expected = new ArrayList<>(Files.readAllLines(whole));
        assertThat(Files.readAllLines(broken).get(3)).endsWith(",1.0,2.0,3.0");
        expected.set(3, Files.readAllLines(broken).get(3));
        assertThat(Files.readAllLines(broken)).isEqualTo(expected);
        assertThat(folder.resolve("broken.csv.trials")).doesNotExist();
    }

    @Test
    void trialThatFailsIsNamedAndTheOthersAreKept() throws IOException {
        Path plan = Files.writeString(
                folder.resolve("x.plan"), "experiment=" + FailsForTwo.class.getName() + "\ntrials=3\na=1,2,3\n");
        Path table = folder.resolve("x.csv");

        Printed printed = Printed.by("experiment", plan.toString(), "--output", table.toString());

        assertThat(printed.exitCode()).isEqualTo(1);
        assertThat(printed.err()).contains("Trial 1 (seed ", "two is too much", "1 trials failed (see above).");
        List<String> rows = Files.readAllLines(table);
        assertThat(rows).hasSize(4);
        assertThat(rows.get(0)).endsWith(",failure");
        assertThat(rows.get(2))
                .startsWith("1,")
                .contains(",2.0,,\"Trial 1 (seed ")
                .contains("two is too much");
        assertThat(rows.get(3)).endsWith(",3.0,6.0,");
        assertThat(Files.readAllLines(folder.resolve("x.csv.trials"))).hasSize(3);
    }

    @Test
    void parameterThatTheExperimentDoesNotHaveIsRefused() throws IOException {
        Path plan = Files.writeString(
                folder.resolve("x.plan"), "experiment=" + PushExperiment.class.getName() + "\ntrials=1\nnewton=20\n");

        Printed printed = Printed.by("experiment", plan.toString());

        assertThat(printed.exitCode()).isEqualTo(2);
        assertThat(printed.err()).contains("\"newton\"", "Did you mean newtons?");
    }

    @Test
    void trialsOfAnotherPlanAreNotMixed() throws IOException {
        Path plan = Files.writeString(
                folder.resolve("x.plan"), "experiment=" + FailsForTwo.class.getName() + "\ntrials=1\na=1\n");
        Files.writeString(folder.resolve("x.csv.trials"), "RoboNewbie trials 0123456789abcdef\n");

        Printed printed = Printed.by(
                "experiment",
                plan.toString(),
                "--output",
                folder.resolve("x.csv").toString());

        assertThat(printed.exitCode()).isEqualTo(2);
        assertThat(printed.err()).contains("x.csv.trials belongs to another run", "delete the file to start over");
    }

    @Test
    void tableDoesNotReplaceThePlan() throws IOException {
        String text = "experiment=" + FailsForTwo.class.getName() + "\ntrials=1\na=1\n";
        Path plan = Files.writeString(folder.resolve("x.csv"), text);

        Printed printed = Printed.by("experiment", plan.toString(), "--output", plan.toString());

        assertThat(printed.exitCode()).isEqualTo(2);
        assertThat(printed.err()).contains("would replace the plan");
        assertThat(plan).hasContent(text);
    }

    @Test
    void tableThatCannotBeWrittenIsToldBeforeTheFirstTrial() throws IOException {
        Path plan = Files.writeString(
                folder.resolve("x.plan"), "experiment=" + FailsForTwo.class.getName() + "\ntrials=1\na=2\n");

        Printed printed = Printed.by(
                "experiment", plan.toString(), "--output", plan.resolve("x.csv").toString());

        assertThat(printed.exitCode()).isNotZero();
        assertThat(printed.err()).contains("x.csv.trials cannot be written").doesNotContain("two is too much");
    }

    /** Doubles its parameter, but cannot do it with 2. */
    public static final class FailsForTwo implements Experiment {

        @Override
        public List<String> columns() {
            return List.of("doubled");
        }

        @Override
        public double[] run(Map<String, Double> parameters, long seed) {
            double a = parameters.getOrDefault("a", 0.0);
            if (a == 2) {
                throw new IllegalStateException("two is too much");
            }
            return new double[] {2 * a};
        }
    }

    @Test
    void whatCannotBeIsToldAsACallThatIsWrong() throws IOException {
        Path plan = Files.writeString(folder.resolve("x.plan"), "experiment=java.lang.String\n");

        assertThat(RoboNewbieCommand.run("experiment", folder.resolve("none").toString()))
                .isEqualTo(2);
        assertThat(RoboNewbieCommand.run("experiment", plan.toString())).isEqualTo(2);
        assertThat(RoboNewbieCommand.run("experiment", plan.toString(), "--engine", "moon"))
                .isEqualTo(2);
        assertThat(RoboNewbieCommand.run("experiment", plan.toString(), "--threads", "0"))
                .isEqualTo(2);
    }
}

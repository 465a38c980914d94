package org.robonewbie.learning.series;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class TrialJournalTest {

    @TempDir
    private Path folder;

    @Test
    void goesOnBehindTheTrialsThatAreDone() throws IOException {
        ExperimentPlan plan = plan();
        Path file = folder.resolve("push.csv.trials");
        measure(file, plan, 2);

        try (TrialJournal again = TrialJournal.open(file, plan)) {
            assertThat(again.done()).isEqualTo(2);
            assertThat(again.missing()).extracting(PlannedTrial::number).containsExactly(2, 3);
        }
        assertThat(folder.resolve("push.csv.trials.part")).doesNotExist();
    }

    @Test
    void doesATrialAgainWhoseLineIsDamaged() throws IOException {
        ExperimentPlan plan = plan();
        Path file = folder.resolve("push.csv.trials");
        measure(file, plan, 3);
        List<String> lines = Files.readAllLines(file);
        Files.write(file, List.of(lines.get(0), "0,1.5,many", "x,1.0,2.0", lines.get(3)));
        Files.writeString(file, "3,1.0", StandardOpenOption.APPEND);

        try (TrialJournal again = TrialJournal.open(file, plan)) {
            assertThat(again.missing()).extracting(PlannedTrial::number).containsExactly(0, 1, 3);
        }
        assertThat(Files.readAllLines(file)).containsExactly(lines.get(0), lines.get(3));
    }

    private static void measure(Path file, ExperimentPlan plan, int trials) throws IOException {
        try (TrialJournal journal = TrialJournal.open(file, plan)) {
            journal.missing()
                    .subList(0, trials)
                    .forEach(trial -> journal.measured(trial, new double[] {trial.number(), 2}));
        }
    }

    private ExperimentPlan plan() throws IOException {
        Path plan = Files.writeString(
                folder.resolve("push.plan"),
                "experiment = " + PushExperiment.class.getName() + "\ntrials = 4\nnewtons = 20\n");
        return ExperimentPlan.read(plan);
    }
}

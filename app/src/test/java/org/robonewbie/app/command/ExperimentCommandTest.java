package org.robonewbie.app.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

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

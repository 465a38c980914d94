package org.robonewbie.learning.policy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.agent.policy.file.PolicyFile;
import org.robonewbie.agent.walk.PolicyWalk;
import org.robonewbie.agent.walk.WalkReflex;
import org.robonewbie.agent.walk.WalkStyle;

class PolicyTrainingTest {

    @TempDir
    private Path folder;

    @Test
    void goesOnAsIfItHadNeverBeenInterruptedWithAnyNumberOfThreads() throws IOException {
        PolicyTraining whole = training("whole.policy", 2, 2);
        whole.run(whole.begin(), line -> {});
        PolicyTraining broken = training("broken.policy", 1, 1);
        broken.run(broken.begin(), line -> {});
        Files.writeString(broken.curve(), "2,killed", StandardOpenOption.APPEND);
        PolicyTraining later = training("broken.policy", 2, 1);

        later.run(later.resume(), line -> {});

        assertThat(later.output()).hasSameTextualContentAs(whole.output());
        assertThat(later.curve()).hasSameTextualContentAs(whole.curve());
        assertThat(Files.readAllLines(later.curve())).hasSize(3);
        assertThat(PolicyFile.read(later.output()).about())
                .containsExactly(
                        "born on a Monday",
                        "learned by: robonewbie learn walk --seed 1 --pairs 1 --spread 0.02 --rate 0.005 --seconds 1.0"
                                + " --push 6.0 --generations 2");
    }

    @Test
    void refusesTheCheckpointOfAnotherTraining() throws IOException {
        PolicyTraining training = training("walk.policy", 1, 1);
        training.run(training.begin(), line -> {});
        PolicyTraining other = new PolicyTraining(WalkCourse.RUN, training.plan(), training.output(), List.of());

        assertThatThrownBy(other::resume)
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("belongs to another training:\n  walk --seed 1")
                .hasMessageContaining("and not to:\n  run --seed 1");
    }

    @Test
    void refusesADamagedCheckpoint() throws IOException {
        PolicyTraining training = training("walk.policy", 1, 1);
        training.run(training.begin(), line -> {});
        String text = Files.readString(training.checkpoint());
        Files.writeString(training.checkpoint(), text.substring(0, text.length() / 2));

        assertThatThrownBy(training::resume)
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("is damaged. Leave out --resume.");
    }

    @Test
    void startsWithAPolicy() throws IOException {
        PolicyTraining training = training("walk.policy", 1, 1);

        double[] mean = training.begin(PolicyFile.shipped("walk")).mean();

        assertThat(WalkCourse.WALK.walk(mean).style()).isEqualTo(new PolicyWalk(PolicyFile.shipped("walk")).style());
    }

    @Tag("slow")
    @Test
    void shippedWalkFallsLessAtItsSpeedThanTheEngineAlone() {
        LessonFigures learned = examine(new PolicyWalk(PolicyFile.shipped("walk")));
        LessonFigures engine = examine(new PolicyWalk(
                WalkStyle.STANDARD.withMost(WalkCourse.WALK.most(), WalkCourse.WALK.backward()), WalkReflex.NONE));

        assertThat(learned.falls()).isLessThan(engine.falls());
        assertThat(learned.fallsIn20Minutes()).isLessThanOrEqualTo(1);
    }

    private static LessonFigures examine(PolicyWalk walk) {
        return Exam.walk(WalkCourse.WALK, walk, 100, 12, 6, 2);
    }

    private PolicyTraining training(String file, int generations, int threads) {
        TrainingPlan plan = new TrainingPlan(1, generations, 1, 0.02, 0.005, 1, 6, List.of(), threads);
        return new PolicyTraining(WalkCourse.WALK, plan, folder.resolve(file), List.of("born on a Monday"));
    }
}

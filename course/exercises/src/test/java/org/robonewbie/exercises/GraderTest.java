package org.robonewbie.exercises;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.agent.Agent;
import org.robonewbie.exercises.solution.RaiseArms;

class GraderTest {

    private final Exercise exercise = Exercises.find("raise-arms").orElseThrow();

    @Test
    void programThatThrowsFailsWithoutStoppingTheOthers() {
        Grade grade = new Grader().grade(exercise, Throwing::new, 2);

        assertThat(grade.trials()).hasSize(2);
        assertThat(grade.passed()).isFalse();
    }

    @Test
    void programThatCannotBeCreatedIsToldWithItsMistake() {
        Grade grade = new Grader()
                .grade(
                        exercise,
                        () -> {
                            throw new IllegalStateException("no robot today");
                        },
                        1);

        assertThat(grade.trials().get(0).score().finding()).contains("no robot today");
    }

    @Tag("slow")
    @Test
    void endlessLoopIsFoundWithItsLine() {
        Grade grade = new Grader().grade(exercise, Looping::new, 1);

        assertThat(grade.trials().get(0).score().finding())
                .contains("think() has not returned for 4 s")
                .contains("GraderTest.java:");
    }

    @Tag("slow")
    @Test
    void programThatSleepsIsFoundAndThoseAfterItAreNotTried() {
        Grade grade = new Grader(1).grade(exercise, Sleeping::new, 2);

        assertThat(grade.trials().get(0).score().finding())
                .contains("think() has not returned for 4 s")
                .contains("GraderTest.java:");
        assertThat(grade.trials().get(1).score().finding())
                .contains("Skipped because an earlier trial did not finish.");
    }

    @Test
    void gradeSurvivesTheWayThroughJson() {
        Grade grade = new Grader().grade(exercise, RaiseArms::new, 2);

        assertThat(Grade.ofJson(grade.json())).isEqualTo(grade);
        assertThat(grade.points()).isEqualTo(10);
    }

    @Test
    void firstSeedIsRecorded(@TempDir Path folder) {
        Path file = folder.resolve("trial.rnrec");

        new Grader().grade(exercise, RaiseArms::new, List.of(5L, 6L), Optional.of(file));

        assertThat(file)
                .exists()
                .satisfies(written -> assertThat(Files.size(written)).isGreaterThan(1000));
    }

    @Test
    void checkForTestsThrowsTheGradeWithHints() {
        ExerciseCheck.assertSolved("raise-arms", RaiseArms::new);

        assertThatThrownBy(() -> ExerciseCheck.assertSolved("raise-arms", Still::new))
                .isInstanceOf(AssertionError.class)
                .hasMessageContaining("not yet passed")
                .hasMessageContaining("Hint: ");
        assertThatThrownBy(() -> ExerciseCheck.assertSolved("nonsense", Still::new))
                .hasMessageContaining("There is no exercise \"nonsense\". The exercises are: raise-arms");
    }

    /** Holds still. */
    private static final class Still extends Agent {}

    /** Makes the same mistake in each cycle. */
    private static final class Throwing extends Agent {
        @Override
        protected void think() {
            throw new IllegalStateException("mistake");
        }
    }

    /** Never comes back. */
    private static final class Looping extends Agent {
        private volatile boolean forEver = true;

        @Override
        protected void think() {
            int rounds = 0;
            while (forEver) {
                rounds++;
            }
            log.info("%d rounds", rounds);
        }
    }

    /** Sleeps where it should think. */
    private static final class Sleeping extends Agent {
        private final CountDownLatch never = new CountDownLatch(1);

        @Override
        protected void think() {
            try {
                never.await();
            } catch (InterruptedException end) {
                Thread.currentThread().interrupt();
            }
        }
    }
}

package org.robonewbie.exercises;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.walk.FastWalk;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.exercises.solution.FasterWalk;

/** The fast walk of the framework is quicker than exercise 16 asks for, and does not count; a walk of the student's own does. */
class GivenWalkTest {

    private static Grade grade(Supplier<Agent> program) {
        return new Grader().grade(Exercises.find("faster-walk").orElseThrow(), program, List.of(1L), Optional.empty());
    }

    private static Agent walking(WalkStyle style) {
        return new Agent() {
            @Override
            protected void think() {
                walk.setStyle(style);
                walk.towards(1, 0, 0);
            }
        };
    }

    @Test
    void fastWalkDoesNotCount() {
        Grade grade = grade(() -> walking(WalkStyle.FAST));

        assertThat(grade.passed()).isFalse();
        assertThat(grade.toString()).contains("with the framework's fast walk", "find your own numbers");
    }

    @Test
    void fastWalkWithOneNumberChangedDoesNotCountEither() {
        double[] x = FastWalk.coordinates();
        x[0] -= 0.3;

        assertThat(grade(() -> walking(FastWalk.style(x))).passed()).isFalse();
    }

    @Test
    void walkThatWasLearnedFromTheStandardOneCounts() {
        assertThat(grade(FasterWalk::new).passed()).isTrue();
    }
}

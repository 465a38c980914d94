package org.robonewbie.learning.optimise;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.TunableNumber;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.motion.file.ShippedMotions;
import org.robonewbie.trial.batch.ThreadRunner;

class RecipeTest {

    private static final Objective FAR = NamedObjective.named("kick-distance");
    private static final Objective WALKED = NamedObjective.named("distance-walked");

    private static final TunableNumber FASTER = new TunableNumber("speed", 0.2, 0.1, 0.5, 0.3);

    @TempDir
    private Path folder;

    static Stream<Parametrization> subjects() {
        AgentScene scene = new AgentScene(new Vector3(-1, 0.5, 0), 10, new Vector3(2, 0, 0), 0.1, 3);
        return Stream.of(
                new MotionParametrization("kick-right", ShippedMotions.file("kick-right"), FAR),
                new WalkParametrization(NamedObjective.named("walk-speed")),
                new AgentParametrization("Walker", Walker::new, WALKED, scene, List.of(FASTER)));
    }

    @ParameterizedTest
    @MethodSource("subjects")
    void copyOnAnotherComputerEvaluatesTheSame(Parametrization subject) throws Exception {
        double[] changed = new double[subject.dimension()];
        changed[0] = 0.5;

        Parametrization copy = sent(subject.recipe()).create(getClass().getClassLoader());

        assertThat(copy.evaluate(changed, 3)).isEqualTo(subject.evaluate(changed, 3));
    }

    private static Parametrization.Recipe sent(Parametrization.Recipe recipe)
            throws IOException, ClassNotFoundException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            out.writeObject(recipe);
        }
        try (ObjectInputStream in = new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray()))) {
            return (Parametrization.Recipe) in.readObject();
        }
    }

    @Test
    void anotherRunnerLeadsToTheSameResult() throws IOException {
        Parametrization kick = new MotionParametrization("kick-right", ShippedMotions.file("kick-right"), FAR);
        OptimisationPlan plan = new OptimisationPlan(1, 2, 4, 1, 0.05, 2, false);

        OptimisationResult here =
                new Optimisation(kick, FAR, plan, folder.resolve("here.txt")).run(false, new ArrayList<>()::add);
        OptimisationResult there = Optimisation.on(new ThreadRunner(2), kick, FAR, plan, folder.resolve("there.txt"))
                .run(false, new ArrayList<>()::add);

        assertThat(there).isEqualTo(here);
    }

    @Test
    void refusesWhatOtherComputersCannotCreate() {
        OptimisationPlan plan = new OptimisationPlan(1, 2, 4, 1, 0.05, 2, false);

        try (ThreadRunner runner = new ThreadRunner(1)) {
            assertThatThrownBy(() -> Optimisation.on(runner, new Hill(), FAR, plan, folder))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessage("hill can be evaluated in this process only. Use --engine local.");
        }
    }

    /** Walks ahead. */
    public static final class Walker extends Agent {

        private final double speed = number("speed", 0.2, 0.1, 0.5);

        /** Creates the robot. */
        public Walker() {}

        @Override
        protected void think() {
            walk.towards(speed, 0, 0);
        }
    }
}

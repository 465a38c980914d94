package org.robonewbie.learning.optimise;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Vector3;

/** A program whose numbers become better. */
class AgentParametrizationTest {

    private static final AgentScene SCENE = new AgentScene(new Vector3(-4, 0, 0), 0, new Vector3(0, 3, 0), 0.2, 4);

    @TempDir
    private Path folder;

    private final AgentParametrization walker =
            new AgentParametrization("Walker", Walker::new, NamedObjective.named("distance-walked"), SCENE);

    @Test
    void sameSeedIsTheSameTrial() {
        Evaluation one = walker.evaluate(new double[2], 3);

        assertThat(walker.evaluate(new double[2], 3)).isEqualTo(one);
        assertThat(walker.evaluate(new double[2], 4)).isNotEqualTo(one);
    }

    @Tag("slow")
    @Test
    void programGetsFurther() throws IOException {
        Path file = folder.resolve("Walker.numbers");
        OptimisationPlan plan = new OptimisationPlan(1, 4, 4, 1, 0.5, 2, false);

        OptimisationResult result = new Optimisation(walker, NamedObjective.named("distance-walked"), plan, file)
                .run(false, generation -> {});

        assertThat(result.after().value()).isGreaterThan(result.before().value() + 0.2);
        assertThat(Files.readString(file))
                .contains(
                        "# made by: robonewbie optimise --agent Walker --pose -4.0,0.0,0.0 --ball 0.0,3.0 --spread 0.2"
                                + " --seconds 4.0 --objective distance-walked")
                .containsPattern("\nthe\\\\ speed = 0\\.\\d+\n");
        assertThat(result.advice()).contains("Walker.numbers").contains("number(\"the speed\", 0.");
    }

    @Test
    void numbersStayWithinTheirRange() {
        assertThat(walker.numbers(new double[2]))
                .containsExactly(new Parameter("the speed", "", 0.1, 0.1), new Parameter("turn", "", 0, 5));
        assertThat(walker.numbers(new double[] {100, -100}))
                .extracting(Parameter::value)
                .containsExactly(0.4, -10.0);
        assertThat(walker.numbers(new double[] {1, 0.5}).get(0).value()).isCloseTo(0.2, within(1e-9));
    }

    @Test
    void savedNumbersAreReadable() throws IOException {
        Path file = folder.resolve("Walker.numbers");

        walker.save(new double[] {1, 0.1234}, Map.of("made by", "hand"), file);

        assertThat(file).hasContent("# made by: hand\nthe\\ speed = 0.2\nturn = 0.62\n");
    }

    @Test
    void programThatScoresSucceeds() {
        AgentScene near = new AgentScene(new Vector3(5.4, 0, 0), 0, new Vector3(5.65, 0, 0), 0, 12);
        AgentParametrization pusher =
                new AgentParametrization("Walker", Walker::new, NamedObjective.named("time-to-score"), near);

        Evaluation fast = pusher.evaluate(new double[] {2, 0}, 1);

        assertThat(fast.success()).isEqualTo(1);
        assertThat(fast.value()).isLessThan(12);
    }

    @Test
    void programWithoutNumbersIsRefused() {
        assertThatThrownBy(() -> new AgentParametrization("Idle", Idle::new, NamedObjective.named("energy"), SCENE))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith("Idle declares no number to optimise. Declare one as a field");
    }

    @Test
    void sceneThatMakesNoSenseIsRefused() {
        assertThatThrownBy(() -> new AgentScene(Vector3.ZERO, 0, Vector3.ZERO, 0.2, 0))
                .hasMessage("--seconds must be above 0 and at most 3600, not 0.0.");
        assertThatThrownBy(() -> new AgentScene(Vector3.ZERO, 0, Vector3.ZERO, -1, 5))
                .hasMessage("--spread must be from 0 to 3 metres, not -1.0.");
    }

    private static final class Walker extends Agent {

        private final double speed = number("the speed", 0.1, 0, 0.4);
        private final double turn = number("turn", 0, -10, 10);

        @Override
        protected void think() {
            walk.towards(speed, 0, turn);
        }
    }

    private static final class Idle extends Agent {}
}

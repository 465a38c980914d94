package org.robonewbie.learning.policy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.policy.file.PolicyFile;
import org.robonewbie.learning.environment.EnvironmentSpec;

class PolicySearchTest {

    @TempDir
    private Path folder;

    @Test
    void interruptedSearchContinuesWithTheSameResult() throws IOException {
        Optional<Policy> shipped = Optional.of(PolicyFile.shipped("walk"));
        PolicySearch whole = search("WalkGait", "whole.policy");
        whole.run(2, shipped, line -> {});
        PolicySearch broken = search("WalkGait", "broken.policy");
        broken.run(1, shipped, line -> {});
        Files.writeString(broken.curve(), "2,killed", StandardOpenOption.APPEND);
        Files.writeString(broken.checkpoint(), "0.1 0.", StandardOpenOption.APPEND);

        broken.run(2, Optional.empty(), line -> {});

        assertThat(broken.output()).hasSameTextualContentAs(whole.output());
        assertThat(broken.curve()).hasSameTextualContentAs(whole.curve());
        assertThat(Files.readAllLines(broken.curve())).hasSize(3);
        assertThat(PolicyFile.read(broken.output()).about())
                .startsWith(shipped.get().about().get(0))
                .endsWith("learned by: robonewbie learn WalkGait --seed 1 --pairs 1 --sigma 0.02 --learning-rate 0.005"
                        + " --option seconds=1 --generations 2");
    }

    @Test
    void refusesTheCheckpointOfAnotherSearch() throws IOException {
        search("WalkGait", "walk.policy").run(1, Optional.empty(), line -> {});

        assertThatThrownBy(() -> search("RunGait", "walk.policy").run(1, Optional.empty(), line -> {}))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("belongs to another run:\n  WalkGait --seed 1")
                .hasMessageContaining("and not to:\n  RunGait --seed 1");
    }

    @Test
    void refusesADamagedCheckpoint() throws IOException {
        PolicySearch search = search("WalkGait", "walk.policy");
        search.run(1, Optional.empty(), line -> {});
        Files.writeString(search.checkpoint(), "1.5\n", StandardOpenOption.APPEND);

        assertThatThrownBy(() -> search.run(2, Optional.empty(), line -> {}))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("is damaged. Delete it to start a new search.");
    }

    @Tag("slow")
    @Test
    void shippedWalkFallsLessAtItsSpeedThanTheEngineAlone() throws IOException {
        PolicyModel walk = model("WalkGait", "constant=0", "seconds=12");
        RolloutStatistics learned = PolicySearch.evaluate(walk, 100, PolicyFile.shipped("walk"));
        RolloutStatistics engine = PolicySearch.evaluate(walk, 100, walk.policy(List.of(), walk.initial(0)));

        assertThat(learned.falls()).isLessThan(engine.falls()).isLessThanOrEqualTo(1);
    }

    private PolicySearch search(String task, String file) {
        EvolutionStrategy strategy = new EvolutionStrategy(1, 1, 0.02, 0.005);
        return new PolicySearch(model(task, "seconds=1"), strategy, folder.resolve(file));
    }

    private static PolicyModel model(String task, String... options) {
        return new PolicyModel(
                new EnvironmentSpec(task, List.of(options)),
                PolicyModel.DEFAULT_INPUTS,
                PolicyModel.DEFAULT_HIDDEN,
                PolicySearchTest.class.getClassLoader());
    }
}

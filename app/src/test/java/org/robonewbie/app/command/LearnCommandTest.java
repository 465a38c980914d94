package org.robonewbie.app.command;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.agent.policy.file.PolicyFile;
import org.robonewbie.agent.walk.PolicyWalk;
import org.robonewbie.programs.CalledWronglyException;
import picocli.CommandLine;

class LearnCommandTest {

    @TempDir
    private Path folder;

    @Test
    void learnsAndContinuesAndEvaluates() throws Exception {
        Path file = folder.resolve("my.policy");

        assertThat(learn(file, "--generations", "1").call()).isZero();
        assertThat(learn(file, "--generations", "2").call()).isZero();

        assertThat(Files.readAllLines(folder.resolve("my.policy.csv"))).hasSize(3);
        assertThat(new PolicyWalk(PolicyFile.read(file)).style().most().forward())
                .isEqualTo(0.8);
        assertThat(command("WalkGait", file.toString(), "--evaluate", "1", "--option", "seconds=1")
                        .call())
                .isZero();
    }

    @Test
    void keepsATrainingWithOtherOptions() throws Exception {
        Path file = folder.resolve("my.policy");
        learn(file, "--generations", "1").call();

        assertThatThrownBy(() -> learn(file, "--sigma", "0.1").call())
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageContaining("belongs to another run");
    }

    @Test
    void runsAsFastAsAnOptionSays() throws Exception {
        Path file = folder.resolve("run.policy");

        command(
                        "RunGait",
                        file.toString(),
                        "--pairs",
                        "1",
                        "--generations",
                        "1",
                        "--option",
                        "seconds=1",
                        "--option",
                        "speed=0.7..1.1")
                .call();

        assertThat(new PolicyWalk(PolicyFile.read(file)).style().most().forward())
                .isEqualTo(1.1);
        assertThat(PolicyFile.read(file).about().get(0))
                .contains(" --option seconds=1 --option speed=0.7..1.1 --generations");
    }

    @ParameterizedTest
    @ValueSource(strings = {"speed=1.1..0.7", "speed=0..1", "speed=1..9", "step=130", "slow=2", "tolerance=0", "slow="})
    void refusesValuesThatAreNotPossible(String option) {
        assertThatThrownBy(() -> command("RunGait", "--option", option).call())
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageStartingWith("The option " + option);
    }

    @Test
    void saysWhatIsWrong() {
        assertThatThrownBy(() -> command("fly").call())
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageStartingWith("There is no task \"fly\". Available: EngineFollow, EngineRun, Follow, ");
        assertThatThrownBy(() -> command("WalkGait", "--pairs", "0").call()).isInstanceOf(CalledWronglyException.class);
        assertThatThrownBy(() -> command("Stand", "shipped").call())
                .isInstanceOf(CalledWronglyException.class)
                .hasMessage("\"shipped\" cannot be overwritten. Add --evaluate EPISODES to evaluate it.");
        assertThatThrownBy(() -> command("Stand", "shipped", "--evaluate", "0").call())
                .isInstanceOf(CalledWronglyException.class)
                .hasMessage("--evaluate must be at least 1, not 0.");
        assertThatThrownBy(() -> command("Stand", "none", "--evaluate", "1", "--seed", "0")
                        .call())
                .isInstanceOf(CalledWronglyException.class)
                .hasMessage("The seed of an evaluation must be between 1 and 1000000000, not 0.");
        assertThatThrownBy(() -> command("WalkGait", folder.resolve("no.policy").toString(), "--evaluate", "1")
                        .call())
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageContaining("no.policy does not exist");
    }

    private static LearnCommand learn(Path file, String... options) {
        List<String> all =
                new ArrayList<>(List.of("WalkGait", file.toString(), "--pairs", "1", "--option", "seconds=1"));
        all.addAll(Arrays.asList(options));
        return command(all.toArray(String[]::new));
    }

    private static LearnCommand command(String... arguments) {
        LearnCommand command = new LearnCommand();
        new CommandLine(command).parseArgs(arguments);
        return command;
    }
}

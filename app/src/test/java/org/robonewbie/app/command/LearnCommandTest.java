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
import org.robonewbie.agent.policy.file.PolicyFile;
import org.robonewbie.agent.walk.PolicyWalk;
import org.robonewbie.programs.CalledWronglyException;
import picocli.CommandLine;

class LearnCommandTest {

    @TempDir
    private Path folder;

    @Test
    void learnsAndGoesOnAndExamines() throws Exception {
        Path file = folder.resolve("my.policy");

        assertThat(learn(file, "--generations", "1").call()).isZero();
        assertThat(learn(file, "--generations", "2", "--resume").call()).isZero();

        assertThat(Files.readAllLines(folder.resolve("my.policy.csv"))).hasSize(3);
        assertThat(new PolicyWalk(PolicyFile.read(file)).style().most().forward())
                .isEqualTo(0.8);
        assertThat(command("walk", "--exam", file.toString(), "--lessons", "1", "--seconds", "1")
                        .call())
                .isZero();
    }

    @Test
    void keepsATrainingThatIsThereAlready() throws Exception {
        Path file = folder.resolve("my.policy");
        learn(file, "--generations", "1").call();

        assertThatThrownBy(() -> learn(file, "--generations", "1").call())
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageContaining("Go on with --resume, choose another --out, or delete it.");
    }

    @Test
    void runsAsFastAsAnOptionSays() throws Exception {
        Path file = folder.resolve("run.policy");

        command(
                        "run",
                        "--pairs",
                        "1",
                        "--seconds",
                        "1",
                        "--generations",
                        "1",
                        "--option",
                        "forward=0.7..1.1",
                        "--out",
                        file.toString())
                .call();

        assertThat(new PolicyWalk(PolicyFile.read(file)).style().most().forward())
                .isEqualTo(1.1);
        assertThat(PolicyFile.read(file).about().get(0))
                .contains(" --push 6.0 --option forward=0.7..1.1 --generations");
        for (String unknown : List.of("noise=1", "forward=1.1", "step=fast", "slow=")) {
            assertThatThrownBy(() -> command("run", "--option", unknown).call())
                    .isInstanceOf(CalledWronglyException.class)
                    .hasMessageContaining("have no option " + unknown + ". There are forward=LOW..HIGH");
        }
        for (String wrong : List.of(
                "forward=1.1..0.7", "forward=0..1", "forward=1..9", "step=130", "step=0", "slow=2", "tolerance=0")) {
            assertThatThrownBy(() -> command("run", "--option", wrong).call())
                    .isInstanceOf(CalledWronglyException.class)
                    .hasMessageContaining("Lessons take " + wrong.replaceAll("=.*", "="))
                    .hasMessageContaining("; " + wrong + " is not possible.");
        }
    }

    @Test
    void saysWhatIsWrong() {
        assertThatThrownBy(() -> command("fly").call())
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageStartingWith("There is no task \"fly\". There are: EngineFollow, EngineRun, Follow, ");
        assertThatThrownBy(
                        () -> learn(folder.resolve("none.policy"), "--resume").call())
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageContaining("There is nothing to resume");
        assertThatThrownBy(() -> command("walk", "--pairs", "0").call()).isInstanceOf(CalledWronglyException.class);
        assertThatThrownBy(() ->
                        command("walk", "--exam", "standard", "--threads", "0").call())
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageContaining("have to be");
        assertThatThrownBy(() -> command(
                                "walk", "--exam", folder.resolve("no.policy").toString())
                        .call())
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageContaining("no.policy does not exist");
    }

    private static LearnCommand learn(Path file, String... options) {
        List<String> all = new ArrayList<>(
                List.of("walk", "--pairs", "1", "--seconds", "1", "--threads", "1", "--out", file.toString()));
        all.addAll(Arrays.asList(options));
        return command(all.toArray(String[]::new));
    }

    private static LearnCommand command(String... arguments) {
        LearnCommand command = new LearnCommand();
        new CommandLine(command).parseArgs(arguments);
        return command;
    }
}

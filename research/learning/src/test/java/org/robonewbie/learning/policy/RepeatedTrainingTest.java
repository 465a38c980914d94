package org.robonewbie.learning.policy;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.policy.file.PolicyFile;
import org.robonewbie.learning.environment.EnvironmentSpec;

/** Repeats the first generation of the trainings of the shipped policies, which gives the same line of the learning curve as then. */
class RepeatedTrainingTest {

    @TempDir
    private Path folder;

    @Tag("slow")
    @Test
    void lastRoundOfTheRunBeginsAsItDid() throws IOException {
        PolicyModel run =
                model("RunGait", "speed=1.2..1.6", "slow=0.1", "tolerance=0.6", "step=140", "push=3", "seconds=6");
        Policy start = kept("run-before-the-last-round.policy");

        String line = firstLine(run, new EvolutionStrategy(6, 20, 0.02, 0.008), Optional.of(start));

        assertThat(line).isEqualTo("1,40,9784,-2.3268,13,0.2641,11.514,27");
    }

    @Tag("slow")
    @Test
    void lastRoundOfTheJogBeginsAsItDid() throws IOException {
        PolicyModel jog = model("JogGait", "speed=0.6..1.15", "type=0..4", "slow=0.6", "push=5");
        Policy start = kept("jog-before-the-last-round.policy");

        String line = firstLine(jog, new EvolutionStrategy(13, 25, 0.015, 0.005), Optional.of(start));

        assertThat(line).isEqualTo("1,50,22230,8.6848,2,0.1016,6.240,48");
    }

    @Test
    void walkIsTrainedAsBefore() throws IOException {
        EvolutionStrategy strategy = new EvolutionStrategy(2, 8, 0.02, 0.005);

        String line = firstLine(model("WalkGait"), strategy, Optional.of(PolicyFile.shipped("walk")));

        assertThat(line).isEqualTo("1,16,6851,10.4923,1,0.0474,4.112,15");
    }

    @Test
    void standIsTrainedAsBefore() throws IOException {
        PolicyModel stand = modelWithInputs("Stand", "gyro.(forward|left)");

        assertThat(firstLine(stand, new EvolutionStrategy(1, 24, 0.02, 0.006), Optional.empty()))
                .isEqualTo("1,48,12903,244.8772,48,,,4");
    }

    @Test
    void kickIsTrainedAsBefore() throws IOException {
        PolicyModel kick = modelWithInputs("KickTo", "command.*");

        assertThat(firstLine(kick, new EvolutionStrategy(1, 16, 0.05, 0.02), Optional.empty()))
                .isEqualTo("1,32,4168,0.0377,10,,,2");
    }

    @Tag("slow")
    @Test
    void getUpIsTrainedAsBefore() throws IOException {
        PolicyModel getUp = modelWithInputs(
                "QuickGetUp", "motion.*|gyro.left|accelerometer.(forward|up)", "friction=0.5..2", "mass=0.9..1.1");

        assertThat(firstLine(getUp, new EvolutionStrategy(1, 24, 0.03, 0.015), Optional.empty()))
                .isEqualTo("1,48,9600,1.8093,48,,,26");
    }

    private String firstLine(PolicyModel model, EvolutionStrategy strategy, Optional<Policy> start) throws IOException {
        PolicySearch search = new PolicySearch(model, strategy, folder.resolve("again.policy"));
        search.run(1, start, line -> {});
        return Files.readAllLines(search.curve()).get(1);
    }

    private static PolicyModel model(String task, String... options) {
        return model(task, PolicyModel.DEFAULT_INPUTS, PolicyModel.DEFAULT_HIDDEN, options);
    }

    private static PolicyModel modelWithInputs(String task, String inputs, String... options) {
        return model(task, inputs, 0, options);
    }

    private static PolicyModel model(String task, String inputs, int hidden, String... options) {
        EnvironmentSpec spec = new EnvironmentSpec(task, List.of(options));
        return new PolicyModel(spec, inputs, hidden, RepeatedTrainingTest.class.getClassLoader());
    }

    private Policy kept(String name) throws IOException {
        Path file = folder.resolve(name);
        try (InputStream text = RepeatedTrainingTest.class.getResourceAsStream("/policies/" + name)) {
            Files.write(file, text.readAllBytes());
        }
        return PolicyFile.read(file);
    }
}

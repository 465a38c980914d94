package org.robonewbie.learning.gym;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.policy.file.PolicyFile;
import org.robonewbie.learning.policy.Course;
import org.robonewbie.learning.policy.EvolutionStrategy;
import org.robonewbie.learning.policy.PolicyTraining;
import org.robonewbie.learning.policy.TrainingPlan;
import org.robonewbie.learning.policy.WalkCourse;

/** The first generation of each training of docs/policies.md once more: it gives the line of the curve that it gave when it was made. */
class RepeatedTrainingTest {

    private static final ClassLoader CLASSES = RepeatedTrainingTest.class.getClassLoader();

    @TempDir
    private Path folder;

    @Test
    void lastRoundOfTheRunBeginsAsItDid() throws IOException {
        List<String> options = List.of("forward=1.2..1.6", "slow=0.1", "tolerance=0.6", "step=140");
        TrainingPlan plan = new TrainingPlan(6, 1, 20, 0.02, 0.008, 6, 3, options, 2);
        Policy start = kept("run-before-the-last-round.policy");

        String line = firstLine(WalkCourse.RUN.with(options), plan, start);

        assertThat(line).isEqualTo("1,40,9784,-2.3268,13,0.2641,11.514,");
    }

    @Test
    void lastRoundOfTheJogBeginsAsItDid() throws IOException {
        List<String> options = List.of("forward=0.6..1.15", "types=0..4", "slow=0.6");
        TrainingPlan plan = new TrainingPlan(13, 1, 25, 0.015, 0.005, 9, 5, options, 2);
        Policy start = kept("jog-before-the-last-round.policy");

        String line = firstLine(WalkCourse.JOG.with(options), plan, start);

        assertThat(line).isEqualTo("1,50,22230,8.6848,2,0.1016,6.240,");
    }

    @Test
    void walkIsTrainedAsBefore() throws IOException {
        TrainingPlan plan = new TrainingPlan(2, 1, 8, 0.02, 0.005, 9, 6, List.of(), 2);

        String line = firstLine(WalkCourse.WALK, plan, PolicyFile.shipped("walk"));

        assertThat(line).isEqualTo("1,16,6851,10.4923,1,0.0474,4.112,");
    }

    @Test
    void standIsTrainedAsBefore() throws IOException {
        Course stand = TaskCourse.of("Stand", "gyro.(forward|left)", 0, CLASSES);
        TrainingPlan plan = new TrainingPlan(1, 1, 24, 0.02, 0.006, 9, 6, List.of(), 2);

        assertThat(firstLine(stand, plan)).isEqualTo("1,48,12903,244.8772,48,,,4");
    }

    @Test
    void kickIsTrainedAsBefore() throws IOException {
        Course kick = TaskCourse.of("KickTo", "command.*", 0, CLASSES);
        TrainingPlan plan = new TrainingPlan(1, 1, 16, 0.05, 0.02, 9, 6, List.of(), 2);

        assertThat(firstLine(kick, plan)).isEqualTo("1,32,4168,0.0377,10,,,2");
    }

    @Test
    void getUpIsTrainedAsBefore() throws IOException {
        Course getUp = TaskCourse.of("QuickGetUp", "motion.*|gyro.left|accelerometer.(forward|up)", 0, CLASSES);
        List<String> options = List.of("friction=0.5..2", "mass=0.9..1.1");
        TrainingPlan plan = new TrainingPlan(1, 1, 24, 0.03, 0.015, 9, 6, options, 2);

        assertThat(firstLine(getUp, plan)).isEqualTo("1,48,9600,1.8093,48,,,26");
    }

    private String firstLine(Course course, TrainingPlan plan) throws IOException {
        PolicyTraining training = training(course, plan);
        return firstLine(training, training.begin());
    }

    private String firstLine(Course course, TrainingPlan plan, Policy start) throws IOException {
        PolicyTraining training = training(course, plan);
        return firstLine(training, training.begin(start));
    }

    private static String firstLine(PolicyTraining training, EvolutionStrategy.State start) throws IOException {
        training.run(start, line -> {});
        return Files.readAllLines(training.curve()).get(1);
    }

    private PolicyTraining training(Course course, TrainingPlan plan) {
        return new PolicyTraining(course, plan, folder.resolve("again.policy"), List.of());
    }

    private Policy kept(String name) throws IOException {
        Path file = folder.resolve(name);
        try (InputStream text = RepeatedTrainingTest.class.getResourceAsStream("/policies/" + name)) {
            Files.write(file, text.readAllBytes());
        }
        return PolicyFile.read(file);
    }
}

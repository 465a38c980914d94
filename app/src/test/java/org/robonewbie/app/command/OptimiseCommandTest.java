package org.robonewbie.app.command;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.app.BoardPage;
import org.robonewbie.app.studio.SearchStudio;
import org.robonewbie.app.studio.SearchStudioOptions;
import org.robonewbie.learning.optimise.Evaluation;
import org.robonewbie.learning.optimise.Generation;
import org.robonewbie.learning.optimise.MotionParametrization;
import org.robonewbie.learning.optimise.Objective;
import org.robonewbie.learning.optimise.Optimisation;
import org.robonewbie.learning.optimise.OptimisationPlan;
import org.robonewbie.learning.optimise.Parametrization;
import org.robonewbie.learning.optimise.SearchDistribution;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.file.ShippedMotions;
import org.robonewbie.programs.CalledWronglyException;
import picocli.CommandLine;

class OptimiseCommandTest {

    @TempDir
    private Path folder;

    @Test
    void leavesACheckpointAndCanGoOn() throws Exception {
        Path output = folder.resolve("kick-right.txt");
        String[] options = {
            "kick-right",
            "--objective",
            "kick-distance",
            "--population",
            "4",
            "--seeds",
            "1",
            "--generations",
            "1",
            "--output",
            output.toString(),
            "--headless"
        };

        command(options).call();
        options[8] = "2";
        String[] more = Arrays.copyOf(options, options.length + 1);
        more[options.length] = "--resume";
        command(more).call();

        assertThat(Files.readAllLines(folder.resolve("kick-right.txt.checkpoint")))
                .hasSize(3);
    }

    @Test
    void namesTheObjectivesIfThereIsNoneOfAName() {
        OptimiseCommand command = command("kick-right", "--objective", "beauty");

        assertThatThrownBy(command::call)
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageStartingWith("There is no measure \"beauty\". Available: distance-walked");
    }

    @Test
    void asksForAnObjective() {
        assertThatThrownBy(() -> command("kick-right").call())
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageStartingWith("Name the measure for optimising kick-right: --objective NAME. Available: ");
    }

    @Test
    void saysThatAMotionIsMissing() {
        assertThatThrownBy(() -> command("fly", "--objective", "energy").call())
                .isInstanceOf(CalledWronglyException.class)
                .hasMessage("There is no shipped motion \"fly\".");
        assertThatThrownBy(() -> command("fly.txt", "--objective", "energy").call())
                .isInstanceOf(CalledWronglyException.class)
                .hasMessage("There is no motion file fly.txt.");
    }

    @Test
    void refusesMotionFilesThatCannotBeRead() throws Exception {
        Path file = Files.writeString(folder.resolve("broken.txt"), "200 1 2 3\n");

        assertThatThrownBy(
                        () -> command(file.toString(), "--objective", "energy").call())
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageContaining("broken.txt cannot be read");
    }

    @Test
    void showsTheSearchOnAPageOfTheStudio() throws Exception {
        Path output = folder.resolve("kick.txt");
        Objective objective = Objective.named("kick-distance", getClass().getClassLoader());
        MotionFile motion = ShippedMotions.file("kick-right");
        Parametrization subject = new MotionParametrization("kick-right", motion, objective);
        OptimisationPlan plan = new OptimisationPlan(1, 2, 4, 1, 0.1, 1, false);
        var optimisation = new Optimisation(subject, objective, plan, output);
        try (SearchStudio studio =
                SearchStudio.open(new SearchStudioOptions(), subject, objective, plan, optimisation, output)) {
            List<Double> middle = Collections.nCopies(subject.dimension(), 0.0);
            List<Double> spread = Collections.nCopies(subject.dimension(), 0.1);

            studio.begins(new Evaluation(5.5, 1, 0));
            studio.reached(new Generation(
                    1,
                    2,
                    new Generation.Score(5.9, 5.7, 1),
                    new SearchDistribution(0.1, middle, spread),
                    new Generation.Pace(8, 30)));

            try (BoardPage page = new BoardPage(URI.create(studio.invitation()), "search")) {
                assertThat(page.next())
                        .contains(
                                "\"subject\":\"kick-right\"",
                                "\"before\":5.5",
                                "\"best\":5.9",
                                "\"trialsPerSecond\":8.0")
                        .contains("keyframe 1, time", "#motion/kick-so-far");
            }
        }
    }

    @Tag("slow")
    @Test
    void improvesAStudentsProgram() throws Exception {
        Path program = Files.writeString(folder.resolve("Walker.java"), """
                import org.robonewbie.agent.Agent;

                public class Walker extends Agent {
                    private final double speed = number("speed", 0.05, 0, 0.4);

                    @Override
                    protected void think() {
                        System.out.println("I walk");
                        walk.towards(speed, 0, 0);
                    }
                }
                """);
        Path numbers = folder.resolve("Walker.numbers");

        int exitCode = command(
                        "--agent",
                        program.toString(),
                        "--objective",
                        "distance-walked",
                        "--seconds",
                        "3",
                        "--pose",
                        "-4,1,0",
                        "--generations",
                        "2",
                        "--population",
                        "4",
                        "--seeds",
                        "1",
                        "--headless",
                        "--output",
                        numbers.toString())
                .call();

        assertThat(exitCode).isZero();
        assertThat(Files.readString(numbers)).containsPattern("(?m)^speed = 0\\.\\d+$");
    }

    @Test
    void saysWhatIsMissingForAnAgent() {
        assertThatThrownBy(() -> command("kick-right", "--agent", "Walker.java", "--objective", "energy")
                        .call())
                .hasMessage("Name exactly one subject to optimise: a motion, walk-engine, or --agent CLASS.");
        assertThatThrownBy(() -> command("--agent", "Agent_Dance", "--objective", "energy")
                        .call())
                .hasMessageStartingWith("Agent_Dance declares no number to optimise.");
        assertThatThrownBy(() -> command("--agent", "Agent_Dance", "--objective", "energy", "--pose", "1,2")
                        .call())
                .hasMessageStartingWith("--pose needs three numbers, such as -1,0,0, and --ball two");
    }

    private static OptimiseCommand command(String... arguments) {
        OptimiseCommand command = new OptimiseCommand();
        new CommandLine(command).parseArgs(arguments);
        return command;
    }
}

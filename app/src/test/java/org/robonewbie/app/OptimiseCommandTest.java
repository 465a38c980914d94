package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

class OptimiseCommandTest {

    @TempDir
    private Path folder;

    @Test
    void makesAMotionOfTheLibraryAgain() throws IOException {
        OptimiseCommand command = command("turn-left-small", "--again", "--output", folder.toString());

        assertThat(command.call()).isZero();
        assertThat(Files.readString(folder.resolve("turn-right-small.txt")))
                .contains("// made by: robonewbie optimise turn-left-small --again");
    }

    @Test
    void leavesACheckpointAndCanGoOn() throws IOException {
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
            output.toString()
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
                .hasMessageStartingWith("There is no objective \"beauty\". There are: distance-walked");
    }

    @Test
    void asksForAnObjective() {
        assertThatThrownBy(() -> command("kick-right").call())
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageStartingWith("Say at what kick-right shall become better: --objective NAME. There are: ");
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
    void refusesMotionFilesThatCannotBeRead() throws IOException {
        Path file = Files.writeString(folder.resolve("broken.txt"), "200 1 2 3\n");

        assertThatThrownBy(
                        () -> command(file.toString(), "--objective", "energy").call())
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageContaining("broken.txt cannot be read");
    }

    private static OptimiseCommand command(String... arguments) {
        OptimiseCommand command = new OptimiseCommand();
        new CommandLine(command).parseArgs(arguments);
        return command;
    }
}

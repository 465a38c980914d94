package org.robonewbie.simulator.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.simulator.state.WorldState;
import org.robonewbie.simulator.world.SoccerWorld;

class StateFileTest {

    @TempDir
    private Path folder;

    @Test
    void aFileHoldsAStateAndNothingElseIsLeft() throws IOException {
        WorldState state = new SoccerWorld(SoccerField.LEAGUE).save();
        Path file = folder.resolve("start" + StateFile.ENDING);

        StateFile.write(state, file);

        assertThat(StateFile.read(file)).isEqualTo(state);
        try (Stream<Path> files = Files.list(folder)) {
            assertThat(files).containsExactly(file);
        }
    }

    @Test
    void aForeignFileIsRefusedByName() throws IOException {
        Path file = folder.resolve("broken" + StateFile.ENDING);
        Files.writeString(file, "RNSTATF");

        assertThatIllegalArgumentException()
                .isThrownBy(() -> StateFile.read(file))
                .withMessage(file + ": This is not a saved world state (byte 6). Choose another file.");
    }
}

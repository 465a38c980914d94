package org.robonewbie.simulator.state;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.world.SoccerWorld;

class WorldStateTest {

    private final SoccerWorld world = new SoccerWorld(SoccerField.LEAGUE);
    private final byte[] bytes = stateOfOneRobot();

    private byte[] stateOfOneRobot() {
        world.addRobot(RobotType.TYPE_0);
        for (int i = 0; i < 30; i++) {
            world.step();
        }
        return world.save().toBytes();
    }

    @Test
    void bytesGiveTheSameState() {
        WorldState state = WorldState.ofBytes(bytes);

        assertThat(state).isEqualTo(world.save()).hasSameHashCodeAs(world.save());
        assertThat(state.toBytes()).isEqualTo(bytes);
    }

    @Test
    void anyChangedByteIsNoticed() {
        Random random = new Random(3);
        for (int i = 0; i < 300; i++) {
            byte[] damaged = bytes.clone();
            damaged[i < 30 ? i : random.nextInt(bytes.length)] ^= (byte) (1 << random.nextInt(8));

            assertThatIllegalArgumentException()
                    .isThrownBy(() -> WorldState.ofBytes(damaged))
                    .withMessageMatching(".*(byte \\d+|version -?\\d+).*");
        }
    }

    @Test
    void aFileThatWasCutIsRefused() {
        for (int length = 0; length < bytes.length; length += 97) {
            byte[] cut = Arrays.copyOf(bytes, length);

            assertThatIllegalArgumentException().isThrownBy(() -> WorldState.ofBytes(cut));
        }
    }

    @Test
    void anotherFileIsRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> WorldState.ofBytes(new byte[] {'R', 'N', 'x', 0, 0, 0, 0, 0, 0}))
                .withMessage("This is not a saved world state (byte 2). Choose another file.");
    }

    @Test
    void anotherVersionIsNamed() {
        byte[] later = bytes.clone();
        later[7] = 9;

        assertThatIllegalArgumentException()
                .isThrownBy(() -> WorldState.ofBytes(later))
                .withMessage(
                        "The saved state has version 9, but this version of RoboNewbie reads only version 1. Save the state again.");
    }
}

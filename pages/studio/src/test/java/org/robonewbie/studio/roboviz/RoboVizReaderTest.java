package org.robonewbie.studio.roboviz;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.TeamSide;

class RoboVizReaderTest {

    private static List<RoboVizCommand> read(byte[] datagram) {
        return RoboVizReader.read(datagram, datagram.length);
    }

    @Test
    void allShapesAreRead() {
        byte[] datagram = new Datagram()
                .bytes(1, 0)
                .numbers("1.0000", "-2.500", "0.5000", "2.0000")
                .bytes(255, 128, 0)
                .text("Stars.3")
                .bytes(1, 1)
                .numbers("     1", "     2", "     3", "     4", "     5", "     6", "     1")
                .bytes(0, 0, 9)
                .text("a")
                .bytes(1, 2)
                .numbers("3.1415", "0.0000", "0.0000", "5.0000")
                .bytes(1, 2, 3)
                .text("b")
                .bytes(1, 3)
                .numbers("0.0000", "0.0000", "1.0000", "0.2000")
                .bytes(1, 2, 3)
                .text("b")
                .bytes(1, 4, 3, 9, 9, 9, 51)
                .numbers("0.0000", "0.0000", "0.0000", "1.0000", "0.0000", "0.0000", "0.0000", "1.0000", "0.0000")
                .text("c")
                .bytes(2, 0)
                .numbers("0.0000", "1.0000", "2.0000")
                .bytes(0, 255, 0)
                .text("Tör")
                .text("d")
                .done();

        List<RoboVizCommand> commands = read(datagram);

        assertThat(commands).hasSize(6);
        assertThat(commands.get(0))
                .isEqualTo(
                        new RoboVizCommand.Draw("Stars.3", "circle", List.of(1.0, -2.5, 0.5, 2.0), "#ff8000", 1, ""));
        assertThat(commands.get(4))
                .isEqualTo(new RoboVizCommand.Draw(
                        "c", "polygon", List.of(0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0), "#090909", 0.2, ""));
        assertThat(commands.get(5))
                .isEqualTo(new RoboVizCommand.Draw("d", "text", List.of(0.0, 1.0, 2.0), "#00ff00", 1, "Tör"));
    }

    @Test
    void highestBitSelectsTheRightTeam() {
        assertThat(read(new Datagram()
                        .bytes(2, 1, 128 + 6, 1, 2, 3)
                        .text("attack")
                        .bytes(2, 2, 0)
                        .done()))
                .containsExactly(
                        new RoboVizCommand.AgentText(TeamSide.RIGHT, 7, "#010203", "attack"),
                        new RoboVizCommand.AgentText(TeamSide.LEFT, 1, "#ffffff", ""));
    }

    @Test
    void restOfADatagramAfterAFaultyCommandIsIgnored() {
        byte[] datagram = new Datagram()
                .bytes(0, 0)
                .text("a")
                .bytes(9, 9)
                .bytes(0, 0)
                .text("b")
                .done();

        assertThat(read(datagram)).containsExactly(new RoboVizCommand.Swap("a"));
    }

    @Test
    void commandThatIsCutOffOrHasNoNumberIsIgnored() {
        byte[] whole = new Datagram()
                .bytes(1, 0)
                .numbers("1.0000", "1.0000", "1.0000", "1.0000")
                .bytes(1, 2, 3)
                .text("a")
                .done();
        for (int length = 0; length < whole.length; length++) {
            assertThat(read(Arrays.copyOf(whole, length))).isEmpty();
        }
        assertThat(read(whole)).hasSize(1);
        for (String wrong : List.of("hello!", "   nan", "1e9999", "Infini", "999999")) {
            assertThat(read(new Datagram()
                            .bytes(1, 2)
                            .numbers(wrong, "1.0000", "1.0000", "1.0000")
                            .bytes(1, 2, 3)
                            .text("a")
                            .done()))
                    .as(wrong)
                    .isEmpty();
        }
    }

    @Test
    void anyBytesAreReadWithoutHarm() {
        Random random = new Random(7);
        for (int i = 0; i < 20_000; i++) {
            byte[] bytes = new byte[random.nextInt(600)];
            random.nextBytes(bytes);
            if (bytes.length > 1) {
                bytes[0] = (byte) random.nextInt(4);
                bytes[1] = (byte) random.nextInt(5);
            }
            read(bytes);
        }
    }
}

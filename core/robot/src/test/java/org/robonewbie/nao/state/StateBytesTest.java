package org.robonewbie.nao.state;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;

class StateBytesTest {

    private final StateWriter out = new StateWriter();

    private StateReader in() {
        return new StateReader(out.toBytes());
    }

    /** One thing that can be written, and what reading gives. */
    private interface Item {

        void write(StateWriter out);

        void check(StateReader in);
    }

    private record Count(double value) implements Item {

        @Override
        public void write(StateWriter out) {
            out.putDouble(value);
        }

        @Override
        public void check(StateReader in) {
            assertThat(Double.doubleToRawLongBits(in.getDouble())).isEqualTo(Double.doubleToRawLongBits(value));
        }
    }

    private record Whole(int value, long large) implements Item {

        @Override
        public void write(StateWriter out) {
            out.putInt(value);
            out.putLong(large);
        }

        @Override
        public void check(StateReader in) {
            assertThat(in.getInt()).isEqualTo(value);
            assertThat(in.getLong()).isEqualTo(large);
        }
    }

    private record Words(List<String> texts, Optional<String> last) implements Item {

        @Override
        public void write(StateWriter out) {
            out.putAll(texts, out::putText);
            out.putOptional(last, out::putText);
        }

        @Override
        public void check(StateReader in) {
            assertThat(in.getAll(in::getText)).isEqualTo(texts);
            assertThat(in.getOptional(in::getText)).isEqualTo(last);
        }
    }

    private record Choice(boolean yes, TeamSide side, Vector3 place) implements Item {

        @Override
        public void write(StateWriter out) {
            out.putBoolean(yes);
            out.putEnum(side);
            out.putVector(place);
        }

        @Override
        public void check(StateReader in) {
            assertThat(in.getBoolean()).isEqualTo(yes);
            assertThat(in.getEnum(TeamSide.values())).isEqualTo(side);
            assertThat(in.getVector()).isEqualTo(place);
        }
    }

    private static Item anyItem(Random random) {
        return switch (random.nextInt(4)) {
            case 0 -> new Count(Double.longBitsToDouble(random.nextLong()));
            case 1 -> new Whole(random.nextInt(), random.nextLong());
            case 2 ->
                new Words(
                        random.ints(random.nextInt(4), 0, 0x3000)
                                .mapToObj(Character::toString)
                                .toList(),
                        random.nextBoolean() ? Optional.empty() : Optional.of("Grüße " + random.nextInt()));
            default ->
                new Choice(
                        random.nextBoolean(),
                        TeamSide.values()[random.nextInt(2)],
                        new Vector3(random.nextGaussian(), -0.0, Double.POSITIVE_INFINITY));
        };
    }

    @Test
    void anySequenceIsReadBackToTheBit() {
        Random random = new Random(4);
        for (int round = 0; round < 10; round++) {
            StateWriter writer = new StateWriter();
            List<Item> items = new ArrayList<>();
            for (int i = 0; i < 400; i++) {
                items.add(anyItem(random));
            }
            items.forEach(item -> item.write(writer));
            StateReader reader = new StateReader(writer.toBytes());

            items.forEach(item -> item.check(reader));

            reader.finish();
        }
    }

    @Test
    void bytesThatAreCutAnywhereAreRefusedWithThePlace() {
        out.putText("striker");
        out.putAll(List.of(1.5, 2.5), out::putDouble);
        byte[] whole = out.toBytes();

        for (int length = 0; length < whole.length; length++) {
            StateReader cut = new StateReader(Arrays.copyOf(whole, length));

            assertThatIllegalArgumentException()
                    .isThrownBy(() -> {
                        cut.getText();
                        cut.getAll(cut::getDouble);
                    })
                    .withMessageStartingWith("The saved state ")
                    .withMessageContaining("(byte ");
        }
    }

    @Test
    void randomBytesNeverTakeMoreMemoryThanTheyHave() {
        Random random = new Random(8);
        byte[] noise = new byte[64];
        for (int round = 0; round < 2000; round++) {
            random.nextBytes(noise);
            StateReader reader = new StateReader(noise);
            try {
                assertThat(reader.getAll(reader::getText)).hasSizeLessThan(64);
            } catch (IllegalArgumentException refused) {
                assertThat(refused).hasMessageStartingWith("The saved state ");
            }
        }
    }

    @Test
    void aNumberOutOfRangeIsRefused() {
        out.putInt(7);

        assertThatIllegalArgumentException()
                .isThrownBy(() -> in().getEnum(TeamSide.values()))
                .withMessageStartingWith("The saved state has index 7 where only 2 elements exist (byte 0).");
    }

    @Test
    void neitherYesNorNoIsRefused() {
        out.putInt(9);

        assertThatIllegalArgumentException()
                .isThrownBy(() -> in().getBoolean())
                .withMessageStartingWith("The saved state has 9 where yes (1) or no (0) is expected (byte 0).");
    }

    @Test
    void bytesAfterTheEndAreRefused() {
        out.putInt(1);
        StateReader reader = in();

        assertThatIllegalArgumentException()
                .isThrownBy(reader::finish)
                .withMessageStartingWith("The saved state has 4 bytes more than expected (byte 0).");
    }
}

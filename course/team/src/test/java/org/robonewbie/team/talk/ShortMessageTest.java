package org.robonewbie.team.talk;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.geometry.Translation2d;

class ShortMessageTest {

    private static final String TEAM = "Blue";

    private final Random random = new Random(3);

    @Test
    void comesOutAsItWentInButRounded() {
        for (int trial = 0; trial < 200; trial++) {
            TeamMessage said = message();

            TeamMessage heard =
                    ShortMessage.decode(ShortMessage.encode(said, TEAM), TEAM).orElseThrow();

            assertThat(heard.number()).isEqualTo(said.number());
            assertThat(heard.role()).isEqualTo(said.role());
            assertThat(heard.fallen()).isEqualTo(said.fallen());
            assertThat(heard.pose().translation().distanceTo(said.pose().translation()))
                    .isLessThan(0.16);
            assertThat(heard.pose().degrees()).isCloseTo(said.pose().degrees(), within(6.0));
            assertThat(heard.ball().distanceTo(said.ball())).isLessThan(0.16);
            assertThat(heard.ballAgeSeconds()).isCloseTo(said.ballAgeSeconds(), within(0.45));
            assertThat(heard.secondsToBall()).isCloseTo(said.secondsToBall(), within(0.51));
        }
    }

    @Test
    void hasTenCharactersThatMayBeSaid() {
        for (int trial = 0; trial < 200; trial++) {
            assertThat(ShortMessage.encode(message(), TEAM)).matches("[0-9A-Za-z+-]{10}");
        }
    }

    @Test
    void isNotUnderstoodByTheOtherTeam() {
        for (int trial = 0; trial < 200; trial++) {
            assertThat(ShortMessage.decode(ShortMessage.encode(message(), TEAM), "Red"))
                    .isEmpty();
        }
    }

    @Test
    void longMessageIsNotMistakenForAShortOne() {
        assertThat(ShortMessage.decode(message().encode(), TEAM)).isEmpty();
    }

    private TeamMessage message() {
        return new TeamMessage(
                1 + random.nextInt(7),
                new Pose2d(upTo(27), upTo(18), upTo(180)),
                random.nextBoolean(),
                TeamRole.values()[random.nextInt(TeamRole.values().length)],
                new Translation2d(upTo(27), upTo(18)),
                Translation2d.ORIGIN,
                6 * random.nextDouble(),
                62 * random.nextDouble(),
                0,
                Translation2d.ORIGIN);
    }

    private double upTo(double most) {
        return most * (2 * random.nextDouble() - 1);
    }
}

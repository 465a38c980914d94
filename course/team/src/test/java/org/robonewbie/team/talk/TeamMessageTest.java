package org.robonewbie.team.talk;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.HashSet;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.geometry.Translation2d;

class TeamMessageTest {

    private final Random random = new Random(3);

    @Test
    void comesOutAsItWentIn() {
        for (int trial = 0; trial < 200; trial++) {
            TeamMessage said = message();

            TeamMessage heard = TeamMessage.decode(said.encode()).orElseThrow();

            assertThat(heard.number()).isEqualTo(said.number());
            assertThat(heard.role()).isEqualTo(said.role());
            assertThat(heard.receiver()).isEqualTo(said.receiver());
            assertThat(heard.fallen()).isEqualTo(said.fallen());
            assertThat(heard.pose().translation().distanceTo(said.pose().translation()))
                    .isLessThan(0.04);
            assertThat(heard.pose().degrees()).isCloseTo(said.pose().degrees(), within(1.5));
            assertThat(heard.ball().distanceTo(said.ball())).isLessThan(0.04);
            assertThat(heard.ballVelocity().distanceTo(said.ballVelocity())).isLessThan(0.1);
            assertThat(heard.ballAgeSeconds()).isCloseTo(said.ballAgeSeconds(), within(0.11));
            assertThat(heard.secondsToBall()).isCloseTo(said.secondsToBall(), within(0.06));
            assertThat(heard.passTarget().distanceTo(said.passTarget())).isLessThan(0.16);
        }
    }

    @Test
    void hasOnlyCharactersThatMayBeSaidAndNotMoreThanTwenty() {
        for (int trial = 0; trial < 200; trial++) {
            assertThat(message().encode()).matches("[0-9A-Za-z+-]{1,20}");
        }
    }

    @Test
    void saysTheLimitForWhatIsBeyondIt() {
        Translation2d far = new Translation2d(1000, -1000);
        Pose2d pose = new Pose2d(1000, -1000, 0);
        String text = new TeamMessage(1, pose, false, TeamRole.KEEPER, far, far, Double.POSITIVE_INFINITY, 99, 0, far)
                .encode();

        TeamMessage heard = TeamMessage.decode(text).orElseThrow();

        assertThat(heard.ball().distanceTo(new Translation2d(20.5, -20.5))).isLessThan(0.01);
        assertThat(heard.ballAgeSeconds()).isCloseTo(TeamMessage.MAX_AGE_SECONDS, within(0.01));
    }

    @Test
    void doesNotMistakeWhatOthersSay() {
        assertThat(TeamMessage.decode("ball-123")).isEmpty();
        assertThat(TeamMessage.decode("")).isEmpty();
        assertThat(TeamMessage.decode("(((((((((((((((((((")).isEmpty();
        String said = message().encode();
        char other = said.charAt(5) == 'A' ? 'B' : 'A';
        assertThat(TeamMessage.decode(said.substring(0, 5) + other + said.substring(6)))
                .isEmpty();
    }

    @Test
    void eachNumberHasATimeOfItsOwnToSpeak() {
        Set<Integer> spoken = new HashSet<>();
        for (int cycle = 1000; cycle < 1022; cycle++) {
            for (int number = 1; number <= 11; number++) {
                if (Talk.isMyTurn(cycle * 0.02, number)) {
                    assertThat(cycle % 2).isZero();
                    assertThat(spoken.add(number)).isTrue();
                }
            }
        }
        assertThat(spoken).hasSize(11);
    }

    private TeamMessage message() {
        return new TeamMessage(
                1 + random.nextInt(11),
                new Pose2d(upTo(20), upTo(20), upTo(180)),
                random.nextBoolean(),
                TeamRole.values()[random.nextInt(TeamRole.values().length)],
                new Translation2d(upTo(20), upTo(20)),
                new Translation2d(upTo(6), upTo(6)),
                6 * random.nextDouble(),
                25 * random.nextDouble(),
                random.nextInt(12),
                new Translation2d(upTo(20), upTo(20)));
    }

    private double upTo(double most) {
        return most * (2 * random.nextDouble() - 1);
    }
}

package org.robonewbie.trial;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.robonewbie.simulator.recording.RecordingTarget;

class ChallengeTest {

    /** Stay awake for a time; a robot of another team stands beside. */
    private static final class StayAwake implements Challenge {

        private final double until;
        private double begun = -1;
        private int acts;
        private double seconds;

        StayAwake(double until) {
            this.until = until;
        }

        @Override
        public Scene scene(RandomSource random) {
            return Scene.of(
                    RobotStart.at(-random.between(1, 2), 0), RobotStart.at(2, 0).withTeam("Others", 1));
        }

        @Override
        public void begin(Trial trial) {
            begun = trial.seconds();
        }

        @Override
        public void act(Trial trial) {
            acts++;
        }

        @Override
        public void see(WorldState state) {
            seconds = state.seconds();
        }

        @Override
        public double value() {
            return seconds;
        }

        @Override
        public String unit() {
            return "s";
        }

        @Override
        public boolean isDecided() {
            return seconds >= until;
        }
    }

    private static double play(Challenge challenge, double seconds) {
        return challenge.play(seconds, 3, "Reds", Controller::ofSpeeds, TrialListener.NONE, RecordingTarget.NONE);
    }

    @Test
    void endsWhenItIsDecided() {
        StayAwake challenge = new StayAwake(0.3);

        double seconds = play(challenge, 5);

        assertThat(seconds).isCloseTo(0.3, within(0.021));
        assertThat(challenge.begun).isZero();
        assertThat(challenge.acts).isEqualTo(Math.round(seconds / 0.02));
        assertThat(challenge.figures()).isEqualTo(Map.of("value", seconds));
    }

    @Test
    void endsWithItsTime() {
        assertThat(play(new StayAwake(9), 0.1)).isCloseTo(0.1, within(1e-9));
    }

    @Test
    void contenderPlaysInTheTeamOfItsName() {
        StayAwake challenge = new StayAwake(0.1);
        List<RobotStart> robots =
                challenge.scene(new RandomSource(1)).withTeam("Reds").robots();

        assertThat(robots).extracting(RobotStart::team).containsExactly("Reds", "Others");
    }

    @Test
    void mistakeAtTheBeginningIsPassedOn() {
        Challenge broken = new Challenge() {
            @Override
            public Scene scene(RandomSource random) {
                return Scene.of(RobotStart.at(0, 0));
            }

            @Override
            public void begin(Trial trial) {
                throw new IllegalStateException("no rules");
            }

            @Override
            public void see(WorldState state) {}

            @Override
            public double value() {
                return 0;
            }

            @Override
            public String unit() {
                return "";
            }
        };

        assertThatThrownBy(() -> play(broken, 1)).hasMessage("no rules");
    }
}

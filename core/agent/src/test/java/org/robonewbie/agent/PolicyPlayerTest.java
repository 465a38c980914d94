package org.robonewbie.agent;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.agent.policy.Network;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.policy.Quantity;

class PolicyPlayerTest {

    @ParameterizedTest
    @CsvSource({
        "joint.LEFT_KNEE_PITCH, degrees",
        "gyro.forward, degrees/s",
        "rightFoot.force.up, N",
        "gyro.up@-3, degrees/s"
    })
    void takesWhatARobotFeels(String input, String unit) {
        assertThatCode(() -> player(input, unit, "joint.LEFT_KNEE_PITCH")).doesNotThrowAnyException();
    }

    @Test
    void saysWhatARobotDoesNotFeelOrMove() {
        assertThatThrownBy(() -> player("gyro.forwards", "degrees/s", "joint.LEFT_KNEE_PITCH"))
                .hasMessage(
                        "The robot has no sensor gyro.forwards in degrees/s. Did you mean gyro.forward in degrees/s?");
        assertThatThrownBy(() -> player("gyro.forward", "rad/s", "joint.LEFT_KNEE_PITCH"))
                .hasMessageStartingWith("The robot has no sensor gyro.forward in rad/s.");
        assertThatThrownBy(() -> player("gyro.forward", "degrees/s", "wing"))
                .hasMessageStartingWith("The policy moves wing, which is not a joint.");
    }

    @Test
    void acceptsOnlyTheCommandsOfThePolicy() {
        PolicyPlayer player = player("command.distance", "m", "joint.LEFT_KNEE_PITCH");

        assertThatCode(() -> player.setCommand("distance", 3)).doesNotThrowAnyException();
        assertThatThrownBy(() -> player.setCommand("speed", 3))
                .hasMessage("This policy has no command \"speed\". Its commands: distance.");
        assertThatThrownBy(() -> player("gyro.left", "degrees/s", "joint.LEFT_KNEE_PITCH")
                        .setCommand("speed", 3))
                .hasMessage("This policy has no command \"speed\". Its commands: none.");
    }

    @Test
    void takesHowFarAMotionHasGotOnlyIfItHasOne() {
        assertThatThrownBy(() -> player("motion.sine-1", "1", "joint.LEFT_KNEE_PITCH"))
                .hasMessageStartingWith("The robot has no sensor motion.sine-1 in 1.");
    }

    private static PolicyPlayer player(String input, String unit, String output) {
        return new PolicyPlayer(new Policy(
                "test",
                List.of(),
                Map.of(),
                List.of(new Quantity(input, unit)),
                List.of(new Quantity(output, "30 degrees")),
                Network.of(new int[] {1, 1}, 0, 1)));
    }
}

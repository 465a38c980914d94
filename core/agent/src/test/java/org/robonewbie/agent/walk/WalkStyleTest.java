package org.robonewbie.agent.walk;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.robonewbie.nao.model.RobotType;

class WalkStyleTest {

    @ParameterizedTest
    @EnumSource(value = RobotType.class, mode = EnumSource.Mode.EXCLUDE, names = "TYPE_3")
    void mostRobotsWalkFastInTheSameWay(RobotType type) {
        assertThat(WalkStyle.fast(type)).isEqualTo(WalkStyle.FAST);
    }

    @Test
    void longestLegsAreAskedForLessSpeedAheadOnly() {
        WalkVelocity most = WalkStyle.fast(RobotType.TYPE_3).most();

        assertThat(most.forward()).isLessThan(WalkStyle.FAST.most().forward());
        assertThat(most.turn()).isEqualTo(WalkStyle.FAST.most().turn());
    }
}

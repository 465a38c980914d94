package org.robonewbie.learning.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.robonewbie.nao.model.RobotType;

class FallenPoseTest {

    @ParameterizedTest
    @EnumSource
    void robotsFallOnTheSideThatIsWanted(FallenPose lying) {
        try (MotionTrial robot = lying.fallen(RobotType.TYPE_0, 1)) {
            double height = robot.body().position().z();
            robot.hold(0.2);

            assertThat(lying.isTrueOf(robot.body())).isTrue();
            assertThat(height).isLessThan(0.2);
            assertThat(robot.body().position().z()).isCloseTo(height, within(0.005));
        }
    }

    @ParameterizedTest
    @EnumSource
    void standingIsNotLying(FallenPose lying) {
        try (MotionTrial robot = MotionTrial.inStance(1, 0)) {
            assertThat(lying.isTrueOf(robot.body())).isFalse();
        }
    }
}

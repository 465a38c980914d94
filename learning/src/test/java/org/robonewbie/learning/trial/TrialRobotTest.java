package org.robonewbie.learning.trial;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.motion.Posture;

class TrialRobotTest {

    @Test
    void breaksOffWhenTheObserverWantsTo() {
        TrialRobot robot = new TrialRobot();

        boolean done = robot.hold(1, seen -> seen.seconds() < 0.1);

        assertThat(done).isFalse();
        assertThat(robot.seconds()).isCloseTo(0.1, within(1e-9));
    }

    @Test
    void fallsWhenPushedHard() {
        TrialRobot robot = new TrialRobot();
        Watch watch = new Watch();

        robot.hold(0.4, pushed -> {
            pushed.push(new Vector3(-40, 0, 0));
            return true;
        });
        boolean done = robot.hold(3, watch);

        assertThat(done).isFalse();
        assertThat(watch.hasFallen()).isTrue();
    }
}

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
    void obeysACommandOneCycleLate() {
        TrialRobot robot = new TrialRobot();
        List<Double> angles = new ArrayList<>();

        robot.moveTo(Posture.ZERO.with(Joint.NECK_YAW, 50), 1000, seen -> {
            angles.add(seen.posture().degrees(Joint.NECK_YAW));
            return true;
        });

        assertThat(angles.get(0)).isCloseTo(0, within(0.02));
        assertThat(angles.get(1)).isCloseTo(1, within(0.02));
        assertThat(angles.get(2)).isCloseTo(2, within(0.02));
    }

    @Test
    void sensesAnglesInHundredthsOfADegree() {
        TrialRobot robot = new TrialRobot();

        robot.moveTo(Posture.ZERO.with(Joint.NECK_YAW, 12.3456), 500, TrialObserver.NONE);

        double sensed = robot.posture().degrees(Joint.NECK_YAW) * 100;
        assertThat(sensed).isCloseTo(Math.rint(sensed), within(1e-6));
    }

    @Test
    void looksAlongTheWorldsXAxisAtFirst() {
        TrialRobot robot = new TrialRobot();

        assertThat(robot.headingDegrees()).isCloseTo(0, within(1e-6));
        assertThat(robot.torso()).isEqualTo(TrialRobot.START);
        assertThat(robot.uprightness()).isCloseTo(1, within(1e-9));
    }

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

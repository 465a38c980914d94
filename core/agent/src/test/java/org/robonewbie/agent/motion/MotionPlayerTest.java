package org.robonewbie.agent.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Interpolation;
import org.robonewbie.nao.motion.JointStates;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.MotionPlayer;
import org.robonewbie.nao.motion.Motors;
import org.robonewbie.nao.motion.Posture;

class MotionPlayerTest {

    private static final Joint JOINT = Joint.LEFT_SHOULDER_PITCH;

    private final JointStates joints = new JointStates();
    private final Motors motors = new Motors(joints);
    private final IdealRobot robot = new IdealRobot(Posture.ZERO);

    @Test
    void turnsAJointWithConstantSpeedByLinearInterpolation() {
        MotionPlayer player = player(frame(400, 40));

        robot.cycle(joints, motors, player);
        double first = motors.sentDegreesPerSecond(JOINT);
        cycles(player, 18);
        double nextToLast = motors.sentDegreesPerSecond(JOINT);

        assertThat(first).isCloseTo(100, within(1e-9));
        assertThat(nextToLast).isCloseTo(100, within(1e-6));
    }

    @Test
    void endsAfterTheSumOfItsTimes() {
        MotionPlayer player = player(frame(400, 40), frame(600, -20));

        cycles(player, 49);
        boolean early = player.isFinished();
        cycles(player, 1);

        assertThat(early).isFalse();
        assertThat(player.isFinished()).isTrue();
        assertThat(player.seconds()).isEqualTo(1.0);
    }

    @Test
    void reachesEachKeyframeAndFlowsThroughIt() {
        MotionPlayer player = player(frame(400, 40), frame(400, 80));

        cycles(player, 20);
        double atKeyframe = motors.sentDegreesPerSecond(JOINT);
        cycles(player, 1);
        double passing = robot.degrees(JOINT);
        double after = motors.sentDegreesPerSecond(JOINT);

        assertThat(passing).isCloseTo(40, within(1e-6));
        assertThat(atKeyframe).isCloseTo(100, within(1e-6));
        assertThat(after).isCloseTo(100, within(1e-6));
    }

    @Test
    void stopsInTheLastPostureAfterTheEnd() {
        MotionPlayer player = player(frame(400, 40));

        cycles(player, 25);

        assertThat(robot.degrees(JOINT)).isCloseTo(40, within(1e-6));
        assertThat(motors.sentDegreesPerSecond(JOINT)).isZero();
    }

    @Test
    void startsFromWhereAMovingJointWillBe() {
        motors.setSpeed(JOINT, 100);
        robot.sense(joints);
        robot.act(motors);
        motors.release();
        MotionPlayer player = player(frame(200, 22));

        robot.cycle(joints, motors, player);

        assertThat(motors.sentDegreesPerSecond(JOINT)).isCloseTo(100, within(1e-9));
    }

    @Test
    void playsKeyframesShorterThanACycleInOneCycleEach() {
        MotionPlayer player = player(frame(20, 5), frame(5, 6), frame(20, 3));

        cycles(player, 4);

        assertThat(player.seconds()).isEqualTo(0.06);
        assertThat(robot.degrees(JOINT)).isCloseTo(3, within(1e-9));
    }

    @Test
    void keepsTheTotalTimeOfOddDurations() {
        MotionPlayer player = player(frame(50, 10), frame(50, 20), frame(50, 30), frame(50, 40));

        cycles(player, 10);

        assertThat(player.isFinished()).isTrue();
        assertThat(player.seconds()).isEqualTo(0.2);
    }

    @Test
    void neverAsksForMoreThanTheMotorsCanDo() {
        MotionPlayer player = player(frame(20, 100), frame(600, 100));
        double fastest = 0;

        for (int i = 0; i < 31; i++) {
            robot.cycle(joints, motors, player);
            fastest = Math.max(fastest, motors.sentDegreesPerSecond(JOINT));
        }
        robot.cycle(joints, motors, player);

        assertThat(fastest).isEqualTo(JOINT.maxDegreesPerSecond());
        assertThat(robot.degrees(JOINT)).isCloseTo(100, within(0.01));
    }

    @Test
    void saysWhichKeyframeIsTooFastAndHowLongItNeeds() {
        MotionPlayer player = player(frame(400, 40), frame(20, 100));

        List<String> problems = player.problems(motors, 0);

        assertThat(problems)
                .containsExactly(
                        "Motion test turns LEFT_SHOULDER_PITCH by 60 degrees in 20 ms on the way to keyframe 2,"
                                + " which is faster than its motor allows; plan at least 180 ms.");
    }

    @Test
    void keepsOutOfTheStopsWhereAJointNoLongerObeys() {
        MotionPlayer player = player(frame(1000, 500));

        cycles(player, 52);

        assertThat(robot.degrees(JOINT)).isCloseTo(119.9, within(1e-6));
    }

    @Test
    void repeatsALoopFromTheLastPostureToTheFirst() {
        MotionPlayer player = player(frame(200, 10), frame(200, -10));
        player.setLooping(true);

        cycles(player, 31);

        assertThat(player.isFinished()).isFalse();
        assertThat(robot.degrees(JOINT)).isCloseTo(10, within(1e-6));
    }

    @Test
    void leavesAJointAloneThatWasCommandedSinceTheStart() {
        MotionPlayer player = player(frame(400, 40));

        cycles(player, 5);
        motors.setTarget(JOINT, -10, 100);
        cycles(player, 30);

        assertThat(robot.degrees(JOINT)).isCloseTo(-10, within(1e-6));
    }

    @Test
    void makesGoodWhatHoldsTheRobotUp() {
        MotionPlayer player = player(frame(400, 40));

        cycles(player, 10);
        IdealRobot pushed = new IdealRobot(Posture.ZERO.with(JOINT, 10));
        for (int i = 0; i < 12; i++) {
            pushed.cycle(joints, motors, player);
        }

        assertThat(pushed.degrees(JOINT)).isCloseTo(40, within(0.1));
    }

    private void cycles(MotionPlayer player, int count) {
        for (int i = 0; i < count; i++) {
            robot.cycle(joints, motors, player);
        }
    }

    private static MotionPlayer player(Keyframe... frames) {
        return new MotionPlayer(new Motion("test", List.of(frames)), Interpolation.LINEAR);
    }

    private static Keyframe frame(int millis, double degrees) {
        return new Keyframe(millis, Posture.ZERO.with(JOINT, degrees));
    }
}

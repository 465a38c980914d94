package org.robonewbie.agent.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.JointStates;
import org.robonewbie.nao.motion.Motors;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.nao.motion.PostureFollower;

class PostureFollowerTest {

    private final JointStates joints = new JointStates();
    private final Motors motors = new Motors(joints);
    private final IdealRobot robot = new IdealRobot(Posture.ZERO);

    @Test
    void leadsAJointAlongThePlanTwoCyclesLate() {
        PostureFollower follower = new PostureFollower(motors);

        for (int i = 1; i <= 10; i++) {
            robot.sense(joints);
            follower.follow(Posture.ZERO.with(Joint.NECK_YAW, i));
            robot.act(motors);
        }

        assertThat(robot.degrees(Joint.NECK_YAW)).isCloseTo(9, within(1e-6));
    }

    @Test
    void makesUpForWhatPushedAJointAside() {
        PostureFollower follower = new PostureFollower(motors);
        IdealRobot pushed = new IdealRobot(Posture.ZERO.with(Joint.NECK_YAW, 8));

        for (int i = 0; i < 20; i++) {
            pushed.sense(joints);
            follower.follow(Posture.ZERO);
            pushed.act(motors);
        }

        assertThat(pushed.degrees(Joint.NECK_YAW)).isCloseTo(0, within(0.1));
    }

    @Test
    void leavesJointsAloneThatTheProgramCommands() {
        PostureFollower follower = new PostureFollower(motors);
        robot.sense(joints);
        follower.begin();
        motors.setSpeed(Joint.NECK_YAW, 20);

        follower.follow(Posture.ZERO.with(Joint.NECK_YAW, -30));
        motors.endCycle();

        assertThat(motors.sentDegreesPerSecond(Joint.NECK_YAW)).isEqualTo(20);
    }
}

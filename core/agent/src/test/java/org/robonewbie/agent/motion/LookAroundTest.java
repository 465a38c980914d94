package org.robonewbie.agent.motion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Interpolation;
import org.robonewbie.nao.motion.JointStates;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.MotionPlayer;
import org.robonewbie.nao.motion.Motors;
import org.robonewbie.nao.motion.Posture;

class LookAroundTest {

    private final JointStates joints = new JointStates();
    private final Motors motors = new Motors(joints);
    private final IdealRobot robot = new IdealRobot(Posture.ZERO);
    private final LookAround lookAround = new LookAround(motors);

    @Test
    void seesFromSideToSideAndDownToTheFeetInOneRound() {
        double left = 0;
        double right = 0;
        double down = 0;

        for (int i = 0; i < LookAround.ROUND_SECONDS / Cycle.SECONDS + 2; i++) {
            cycle();
            left = Math.max(left, robot.degrees(Joint.NECK_YAW));
            right = Math.min(right, robot.degrees(Joint.NECK_YAW));
            down = Math.min(down, robot.degrees(Joint.NECK_PITCH));
        }

        assertThat(left).isGreaterThan(55);
        assertThat(right).isLessThan(-55);
        assertThat(down).isLessThan(-30);
    }

    @Test
    void neverJerksAlthoughAMotionWantsTheHeadElsewhere() {
        Motion still = new Motion("still", List.of(new Keyframe(300, Posture.ZERO)));
        MotionPlayer player = new MotionPlayer(still, Interpolation.LINEAR);
        player.setLooping(true);
        double largestChange = 0;
        double before = 0;

        for (int i = 0; i < 300; i++) {
            robot.sense(joints);
            lookAround.look();
            player.step(motors);
            robot.act(motors);
            double speed = motors.sentDegreesPerSecond(Joint.NECK_YAW);
            largestChange = i > 2 ? Math.max(largestChange, Math.abs(speed - before)) : 0;
            before = speed;
        }

        assertThat(largestChange).isLessThan(10);
    }

    private void cycle() {
        robot.sense(joints);
        lookAround.look();
        robot.act(motors);
    }
}

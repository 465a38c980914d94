package org.robonewbie.agent.walk;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.OutputStream;
import java.io.PrintStream;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.log.Diagnostics;
import org.robonewbie.agent.motion.MotionSequencer;
import org.robonewbie.agent.perception.BodyPosition;
import org.robonewbie.agent.perception.FootPressure;
import org.robonewbie.agent.perception.TorsoMotion;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.JointStates;
import org.robonewbie.nao.motion.Motors;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.nao.motion.file.MotionFiles;

class WalkTest {

    private final Diagnostics diagnostics = new Diagnostics(new PrintStream(OutputStream.nullOutputStream()));
    private final JointStates joints = new JointStates();
    private final Motors motors = new Motors(joints);
    private BodyPosition bodyPosition = BodyPosition.UPRIGHT;
    private final MotionSequencer motions =
            new MotionSequencer(motors, MotionFiles.library(), diagnostics, () -> bodyPosition);
    private final WalkController walk = new WalkController(motors, motions, diagnostics, () -> bodyPosition);

    @Test
    void walksAtOnceFromTheStance() {
        put(Stance.POSTURE);

        walk.towards(0.1, 0, 0);
        cycles(3);

        assertThat(walk.isWalking()).isTrue();
        assertThat(motions.isFinished()).isTrue();
    }

    @Test
    void goesToTheStanceBeforeItWalks() {
        put(Posture.ZERO);

        walk.towards(0.1, 0, 0);
        cycles(3);
        boolean preparing = motions.current().equals(java.util.Optional.of("stand"));
        cycles(60);

        assertThat(preparing).isTrue();
        assertThat(walk.isWalking()).isTrue();
    }

    @Test
    void stopsBeforeAMotionBegins() {
        put(Stance.POSTURE);
        walk.towards(0.1, 0, 0);
        cycles(40);

        motions.start("wave");
        cycles(1);
        boolean stillWalking = walk.isWalking();
        boolean waving = motions.current().isPresent();
        cycles(100);

        assertThat(stillWalking).isTrue();
        assertThat(waving).isFalse();
        assertThat(walk.isWalking()).isFalse();
        assertThat(motions.current()).contains("wave");
    }

    @Test
    void doesNotWalkWhileItLies() {
        put(Stance.POSTURE);
        walk.towards(0.1, 0, 0);
        cycles(40);

        bodyPosition = BodyPosition.LYING_ON_BACK;
        cycles(1);
        walk.towards(0.1, 0, 0);
        cycles(1);

        assertThat(walk.isWalking()).isFalse();
        assertThat(motors.sentDegreesPerSecond(Joint.LEFT_KNEE_PITCH)).isZero();
    }

    @Test
    void reportsWhatIsNoNumber() {
        put(Stance.POSTURE);

        walk.towards(Double.NaN, 0, 0);
        cycles(1);

        assertThat(walk.isWalking()).isFalse();
        assertThat(diagnostics.reported())
                .anyMatch(line ->
                        line.contains("The walk command NaN, 0.0, 0.0 is ignored. Was something divided by zero?"));
    }

    @Test
    void letsTheUserTurnTheHeadWhileItWalks() {
        put(Stance.POSTURE);
        walk.towards(0.1, 0, 0);
        cycles(10);

        motors.setSpeed(Joint.NECK_YAW, 20);
        cycles(10);

        assertThat(motors.sentDegreesPerSecond(Joint.NECK_YAW)).isEqualTo(20);
    }

    private void put(Posture posture) {
        for (Joint joint : Joint.values()) {
            joints.sense(joint, posture.degrees(joint));
        }
    }

    /** Cycles of a robot whose joints do what they are told at once. */
    private void cycles(int count) {
        for (int i = 0; i < count; i++) {
            walk.update(TorsoMotion.AT_REST, FootPressure.NONE, FootPressure.NONE);
            motors.endCycle();
            for (Joint joint : Joint.values()) {
                double turned = motors.sentDegreesPerSecond(joint) * Cycle.SECONDS;
                joints.sense(joint, joints.degrees(joint) + turned);
            }
        }
    }
}

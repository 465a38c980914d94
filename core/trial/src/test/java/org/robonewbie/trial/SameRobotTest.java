package org.robonewbie.trial;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.file.ShippedMotions;
import org.robonewbie.simulator.world.Robot;

/** Without noise, the direct world and the served one move a robot equally, to the bit. */
class SameRobotTest {

    private static final double SECONDS = 60;

    static Stream<Arguments> controllers() {
        return Stream.of(
                Arguments.of("a motion", (Supplier<Controller>) () -> Controller.ofMotion(longWalk())),
                Arguments.of("a walk", (Supplier<Controller>) () -> Controller.ofWalk(0.2, 0.02, 30)),
                Arguments.of("joint speeds", (Supplier<Controller>) SameRobotTest::swing));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("controllers")
    void directAndServedWorldGiveTheSameRobot(String name, Supplier<Controller> controller) {
        Scene scene = scene();
        try (Trial direct = Trial.direct(scene, 1, controller.get());
                Trial served = Trial.served(scene, 1, controller.get())) {
            while (direct.seconds() < SECONDS) {
                direct.step();
                served.step();

                assertThat(bits(direct.robot(0)))
                        .as("%s after %.2f s", name, direct.seconds())
                        .isEqualTo(bits(served.robot(0)));
            }
            assertThat(direct.now().robot()).isNotNull();
        }
    }

    @Test
    void agentInTheDirectWorldSensesWhatMessagesCarry() {
        List<List<Double>> direct = new ArrayList<>();
        List<List<Double>> served = new ArrayList<>();

        try (Trial one = Trial.direct(scene(), 1, Controller.ofAgent(new Feeling(direct)));
                Trial other = Trial.served(scene(), 1, Controller.ofAgent(new Feeling(served)))) {
            one.run(5);
            other.run(5);
        }

        assertThat(direct).hasSize(250);
        assertThat(direct.subList(1, 250)).isEqualTo(served.subList(1, 250));
    }

    private static Scene scene() {
        return Scene.of(RobotStart.at(-2, 0).after(ShippedMotions.motion("stand")))
                .withBall(5, 3.5)
                .withoutNoise();
    }

    private static List<Long> bits(Robot robot) {
        List<Long> bits = new ArrayList<>();
        for (Joint joint : Joint.values()) {
            bits.add(Double.doubleToRawLongBits(robot.jointDegrees(joint)));
        }
        var torso = robot.torso();
        for (double value : new double[] {
            torso.position().x(), torso.position().y(), torso.position().z(),
            torso.rotation().axisX().x(), torso.rotation().axisX().y(),
                    torso.rotation().axisX().z(),
            torso.rotation().axisY().x(), torso.rotation().axisY().y(),
                    torso.rotation().axisY().z()
        }) {
            bits.add(Double.doubleToRawLongBits(value));
        }
        return bits;
    }

    /** A minute of steps and turns. */
    private static Motion longWalk() {
        List<Keyframe> keyframes = new ArrayList<>();
        for (int i = 0; i < 20; i++) {
            keyframes.addAll(ShippedMotions.motion("walk-forward").keyframes());
            keyframes.addAll(ShippedMotions.motion("turn-left").keyframes());
        }
        return new Motion("long walk", keyframes);
    }

    private static Controller swing() {
        double[] cycle = {0};
        return Controller.ofPolicy(readings -> {
            double[] speeds = new double[Joint.COUNT];
            for (Joint joint : Joint.values()) {
                speeds[joint.ordinal()] = 200 * Math.sin(cycle[0] / 7 + joint.ordinal())
                        + readings.gyro().x() / 10;
            }
            cycle[0]++;
            return speeds;
        });
    }

    /** Remembers what it senses, and nods. */
    private static final class Feeling extends Agent {

        private final List<List<Double>> sensed;

        Feeling(List<List<Double>> sensed) {
            this.sensed = sensed;
        }

        @Override
        protected void think() {
            List<Double> now = new ArrayList<>();
            for (Joint joint : Joint.values()) {
                now.add(nao.getJointAngle(joint));
            }
            now.add(nao.getGyro().x());
            now.add(nao.getAcceleration().x());
            sensed.add(now);
            nao.setJointAngle(Joint.NECK_PITCH, sensed.size() % 50 < 25 ? 20 : -20, 60);
        }
    }
}

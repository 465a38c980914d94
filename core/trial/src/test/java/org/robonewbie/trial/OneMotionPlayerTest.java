package org.robonewbie.trial;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.OutputStream;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.nao.motion.file.ShippedMotions;

/** A motion moves a robot that plays nothing else, as in the motion editor, and an agent's robot alike, to the last bit. */
class OneMotionPlayerTest {

    private static final int CYCLES_AFTERWARDS = 5;

    @AutoClose
    private final Trial alone = trial();

    @AutoClose
    private final Trial agents = trial();

    private static Trial trial() {
        Scene scene = Scene.of(RobotStart.at(0, 0)).withBall(-5, -3.5).withoutNoise();
        return Trial.direct(scene, 1, Controller.ofSpeeds());
    }

    static Stream<String> shippedMotions() {
        return new ShippedMotions().names().stream();
    }

    @ParameterizedTest
    @MethodSource("shippedMotions")
    void performerPlaysAShippedMotionAsAnAgentDoes(String name) {
        assertPlayedAlike(ShippedMotions.motion(name));
    }

    @Test
    void performerPlaysRandomMotionsAsAnAgentDoes() {
        assertPlayedAlike(100, new SplittableRandom(11));
    }

    @Test
    @Tag("slow")
    void performerPlaysAThousandRandomMotionsAsAnAgentDoes() {
        assertPlayedAlike(1000, new SplittableRandom(12));
    }

    private void assertPlayedAlike(int motions, SplittableRandom random) {
        for (int i = 0; i < motions; i++) {
            assertPlayedAlike(randomMotion("random " + i, random));
        }
    }

    private void assertPlayedAlike(Motion motion) {
        Controller player = Controller.ofMotion(motion);
        alone.reset(1, player);
        agents.reset(1, Controller.ofAgent(quiet(motion)));
        for (int cycles = CYCLES_AFTERWARDS; cycles > 0; cycles -= player.isFinished() ? 1 : 0) {
            alone.step();
            agents.step();
            assertThat(degrees(agents)).as(motion.name()).isEqualTo(degrees(alone));
        }
        assertThat(agents.robot(0).torso())
                .as(motion.name())
                .isEqualTo(alone.robot(0).torso());
    }

    /** One to three keyframes of 10 ms to 2 s, short ones as often as long ones, some beyond the joints' ranges. */
    private static Motion randomMotion(String name, SplittableRandom random) {
        List<Keyframe> keyframes = new ArrayList<>();
        for (int i = random.nextInt(1, 4); i > 0; i--) {
            int millis = (int) Math.round(10 * Math.pow(200, random.nextDouble()));
            double[] degrees = new double[Joint.COUNT];
            for (Joint joint : Joint.values()) {
                degrees[joint.ordinal()] = random.nextDouble(joint.minDegrees() - 5, joint.maxDegrees() + 5);
            }
            keyframes.add(new Keyframe(millis, Posture.of(degrees)));
        }
        return new Motion(name, keyframes);
    }

    private static double[] degrees(Trial trial) {
        return Stream.of(Joint.values())
                .mapToDouble(joint -> trial.robot(0).jointDegrees(joint))
                .toArray();
    }

    /** An agent that plays a motion and does not complain that its keyframes are too fast. */
    private static Agent quiet(Motion motion) {
        PrintStream usual = System.err;
        System.setErr(new PrintStream(OutputStream.nullOutputStream()));
        try {
            return new OneMotionAgent(motion);
        } finally {
            System.setErr(usual);
        }
    }

    /** Plays one motion as soon as it senses anything. */
    private static final class OneMotionAgent extends Agent {

        private final Motion motion;
        private boolean started;

        OneMotionAgent(Motion motion) {
            this.motion = motion;
        }

        @Override
        protected void think() {
            started = started || motions.start(motion);
        }
    }
}

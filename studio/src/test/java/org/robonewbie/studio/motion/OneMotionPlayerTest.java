package org.robonewbie.studio.motion;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.OutputStream;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.AgentDriver;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.nao.motion.file.ShippedMotions;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.effector.EffectorCommand.SetHingeSpeed;
import org.robonewbie.protocol.effector.EffectorMessageWriter;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.JointAngles;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PerceptorMessageReader;
import org.robonewbie.protocol.perceptor.PerceptorMessageWriter;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.simulator.world.SoccerWorld;

/** The robot of the motion editor moves as the same motion moves an agent's robot, to the last bit. */
class OneMotionPlayerTest {

    private static final int RANDOM_MOTIONS = 1000;

    static Stream<String> shippedMotions() {
        return new ShippedMotions().names().stream();
    }

    @ParameterizedTest
    @MethodSource("shippedMotions")
    void editorPlaysAShippedMotionAsAnAgentDoes(String name) {
        assertPlayedAlike(ShippedMotions.motion(name));
    }

    @Test
    void editorPlaysRandomMotionsAsAnAgentDoes() {
        SplittableRandom random = new SplittableRandom(11);

        for (int i = 0; i < RANDOM_MOTIONS; i++) {
            assertPlayedAlike(randomMotion("random " + i, random));
        }
    }

    private static void assertPlayedAlike(Motion motion) {
        TrialRobot editor = new TrialRobot();
        List<double[]> expected = new ArrayList<>();
        editor.play(motion, () -> expected.add(degrees(editor.body())));
        editor.hold(0.1, () -> expected.add(degrees(editor.body())));

        AgentRobot agent = new AgentRobot(motion);
        for (double[] degrees : expected) {
            agent.cycle();
            assertThat(degrees(agent.robot)).as(motion.name()).isEqualTo(degrees);
        }
        assertThat(agent.robot.torso())
                .as(motion.name())
                .isEqualTo(editor.body().torso());
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

    private static double[] degrees(Robot robot) {
        return Stream.of(Joint.values()).mapToDouble(robot::jointDegrees).toArray();
    }

    /** A body in a world of its own that an agent moves by messages, as over a connection. */
    private static final class AgentRobot {

        private final SoccerWorld world = new SoccerWorld(SoccerField.BEGINNER);
        private final Robot robot = world.addRobot(RobotType.TYPE_0);
        private final MessageBuffer text = new MessageBuffer();
        private final PerceptorMessageWriter writer = new PerceptorMessageWriter(text);
        private final PerceptorMessageReader reader = new PerceptorMessageReader();
        private final AgentDriver agent;
        private List<EffectorCommand> underWay = List.of();

        AgentRobot(Motion motion) {
            robot.moveUpright(new Vector3(0, 0, 0.39), 0);
            world.ball().place(new Vector3(-5, -3.5, 0.042));
            agent = new AgentDriver(quiet(motion));
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

        void cycle() {
            text.clear();
            writer.write(sensed());
            List<EffectorCommand> answer = agent.respond(reader.read(text));
            for (EffectorCommand command : underWay) {
                if (command instanceof SetHingeSpeed speed) {
                    robot.setMotorSpeed(
                            joint(speed.effectorName()), EffectorMessageWriter.rounded(speed.radiansPerSecond()));
                }
            }
            underWay = answer;
            world.step();
        }

        private PerceptorMessage sensed() {
            PerceptorMessage none = PerceptorMessage.NOTHING;
            return new PerceptorMessage(
                    none.seconds(),
                    none.gameState(),
                    none.heard(),
                    none.gyro(),
                    none.accelerometer(),
                    JointAngles.of(degrees(robot)),
                    none.footForces(),
                    none.vision());
        }

        private static Joint joint(String effectorName) {
            return Stream.of(Joint.values())
                    .filter(joint -> joint.effectorName().equals(effectorName))
                    .findFirst()
                    .orElseThrow();
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

package org.robonewbie.agent;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.agent.cycle.CycleWatch;
import org.robonewbie.agent.cycle.MessagePort;
import org.robonewbie.agent.cycle.RobotRuntime;
import org.robonewbie.agent.cycle.Session;
import org.robonewbie.agent.walk.Stance;
import org.robonewbie.nao.BodyPart;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Landmark;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PolarPosition;
import org.robonewbie.protocol.perceptor.Vision;
import org.robonewbie.protocol.perceptor.Vision.SeenBodyPart;
import org.robonewbie.protocol.perceptor.Vision.SeenLandmark;
import org.robonewbie.protocol.perceptor.Vision.SeenLine;
import org.robonewbie.protocol.perceptor.Vision.SeenPlayer;

/**
 * Measures the bytes that a cycle allocates, not counting the perceptor messages, which are created in advance. A separate JVM runs
 * without the optimising compiler, because the allocations that this compiler avoids depend on the tests that ran before.
 */
class CycleAllocationTest {

    private static final int WARM_UP_CYCLES = 2000;
    private static final int CYCLES = 1000;

    @ParameterizedTest
    @CsvSource({"JOINT, 600", "MOTION, 1000", "WALK, 6000"})
    void cycleAllocatesLittle(Behaviour behaviour, double maxBytes) throws IOException, InterruptedException {
        Process java = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-XX:TieredStopAtLevel=1",
                        "-cp",
                        System.getProperty("java.class.path"),
                        CycleAllocationTest.class.getName(),
                        behaviour.name())
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();

        String bytes = new String(java.getInputStream().readAllBytes(), StandardCharsets.UTF_8);

        assertThat(java.waitFor()).isZero();
        assertThat(Double.parseDouble(bytes)).isLessThan(maxBytes);
    }

    /** Prints the bytes that a cycle of a behaviour allocates. */
    public static void main(String[] args) {
        Behaviour behaviour = Behaviour.valueOf(args[0]);
        RobotRuntime robot = new RobotRuntime("test");
        Session session = new Session(robot, new Replay(), OptionalDouble.empty(), CycleWatch.NONE);
        com.sun.management.ThreadMXBean threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        long self = Thread.currentThread().getId();

        run(behaviour, WARM_UP_CYCLES, robot, session);
        long before = threads.getThreadAllocatedBytes(self);
        run(behaviour, CYCLES, robot, session);
        System.out.println((threads.getThreadAllocatedBytes(self) - before) / (double) CYCLES);
    }

    private static void run(Behaviour behaviour, int cycles, RobotRuntime robot, Session session) {
        for (int i = 0; i < cycles; i++) {
            session.senseNext();
            behaviour.think(robot, i);
            session.act();
        }
    }

    private enum Behaviour {
        JOINT {
            @Override
            void think(RobotRuntime robot, int cycle) {
                robot.commands().setJointSpeed(Joint.NECK_YAW, 30);
            }
        },
        MOTION {
            @Override
            void think(RobotRuntime robot, int cycle) {
                robot.motions().loop("walk-forward");
            }
        },
        WALK {
            @Override
            void think(RobotRuntime robot, int cycle) {
                robot.walk().towards(cycle % 2 == 0 ? 0.3 : 0.1, 0.01, 5);
            }
        };

        abstract void think(RobotRuntime robot, int cycle);
    }

    /** Brings the same three perceptions again and again, one of them with a picture. */
    private static final class Replay implements MessagePort {

        private final List<PerceptorMessage> messages = List.of(
                Messages.standing().posture(Stance.POSTURE).build(),
                Messages.standing().posture(Stance.POSTURE).at(1.02).build(),
                Messages.standing()
                        .posture(Stance.POSTURE)
                        .at(1.04)
                        .seeing(picture())
                        .build());
        private int next;

        @Override
        public boolean receive() {
            next = (next + 1) % messages.size();
            return true;
        }

        @Override
        public PerceptorMessage message() {
            return messages.get(next);
        }

        @Override
        public void send(List<EffectorCommand> commands) {}

        @Override
        public void close() {}

        private static Vision picture() {
            PolarPosition place = new PolarPosition(2, 10, -5);
            return Vision.of(
                    List.of(new SeenLandmark(Landmark.GOAL_POST_1_RIGHT, place)),
                    Optional.of(place),
                    List.of(new SeenPlayer(
                            "Other", 3, List.of(new SeenBodyPart(BodyPart.HEAD, place)), Optional.empty())),
                    List.of(new SeenLine(place, place)));
        }
    }
}

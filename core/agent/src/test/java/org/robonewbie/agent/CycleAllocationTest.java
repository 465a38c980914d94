package org.robonewbie.agent;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
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

/** Counts what cycles allocate beyond the perceptions, which are made beforehand here: at most 4 KB. */
class CycleAllocationTest {

    private static final int ROUNDS = 200;
    private static final int CYCLES = 2000;

    private static final double MAX_BYTES = 4096;

    private final RobotRuntime robot = new RobotRuntime("test");
    private final Session session = new Session(robot, new Replay(), OptionalDouble.empty(), CycleWatch.NONE);

    @Test
    void singleJointAllocatesLittle() {
        assertThat(bytesPerCycle(() -> robot.commands().setJointSpeed(Joint.NECK_YAW, 30)))
                .isLessThan(MAX_BYTES);
    }

    @Test
    void repeatedMotionAllocatesLittle() {
        robot.motions().loop("walk-forward");

        assertThat(bytesPerCycle(() -> {})).isLessThan(MAX_BYTES);
        assertThat(robot.motions().current()).contains("walk-forward");
    }

    @Test
    void walkAllocatesLittle() {
        double[] forward = {0.1};

        assertThat(bytesPerCycle(() -> {
                    forward[0] = 0.4 - forward[0];
                    robot.walk().towards(forward[0], 0.01, 5);
                }))
                .isLessThan(MAX_BYTES);
        assertThat(robot.walk().isWalking()).isTrue();
    }

    /** The least of some rounds, since Java allocates more until it has compiled everything, which takes long beside other work. */
    private double bytesPerCycle(Runnable think) {
        com.sun.management.ThreadMXBean threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        long self = Thread.currentThread().getId();
        double least = Double.POSITIVE_INFINITY;
        for (int round = 0; round < ROUNDS && least >= MAX_BYTES; round++) {
            long before = threads.getThreadAllocatedBytes(self);
            cycles(CYCLES, think);
            least = Math.min(least, (threads.getThreadAllocatedBytes(self) - before) / (double) CYCLES);
        }
        return least;
    }

    private void cycles(int count, Runnable think) {
        for (int i = 0; i < count; i++) {
            session.senseNext();
            think.run();
            session.act();
        }
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

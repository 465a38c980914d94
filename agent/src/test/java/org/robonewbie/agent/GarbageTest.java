package org.robonewbie.agent;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.log.Logger;
import org.robonewbie.agent.log.Mistakes;
import org.robonewbie.agent.motion.MotionLibrary;
import org.robonewbie.agent.motion.Motions;
import org.robonewbie.agent.perception.LocalFieldView;
import org.robonewbie.agent.walk.Stance;
import org.robonewbie.agent.walk.Walk;
import org.robonewbie.nao.BodyPart;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Landmark;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PolarPosition;
import org.robonewbie.protocol.perceptor.Vision;
import org.robonewbie.protocol.perceptor.Vision.SeenBodyPart;
import org.robonewbie.protocol.perceptor.Vision.SeenLandmark;
import org.robonewbie.protocol.perceptor.Vision.SeenLine;
import org.robonewbie.protocol.perceptor.Vision.SeenPlayer;

/** Counts what cycles allocate beyond the perceptions, which are made beforehand here. */
class GarbageTest {

    private static final int CYCLES_TO_SETTLE = 300;
    private static final int CYCLES = 5000;

    /** Any object has at least 16 bytes; Java itself allocates a few kilobytes at times while it compiles. */
    private static final double NOTHING_IN_MOST_CYCLES = 2;

    private final NaoBody body = new NaoBody(new Logger("test"), new Mistakes(System.err));
    private final Motions motions =
            new Motions(body.motors(), new MotionLibrary(), body.mistakes(), body::getBodyPosition);
    private final Walk walk = new Walk(body.motors(), motions, body.mistakes(), body::getBodyPosition);
    private final Session session = new Session(
            body, walk, new LocalFieldView(body.mistakes()), new Replay(), OptionalDouble.empty(), System.err);

    @Test
    void singleJointMakesNoGarbage() {
        assertThat(bytesPerCycle(() -> body.setJointSpeed(Joint.NECK_YAW, 30))).isLessThan(NOTHING_IN_MOST_CYCLES);
    }

    @Test
    void repeatedMotionMakesNoGarbage() {
        motions.loop("walk-forward");

        assertThat(bytesPerCycle(() -> {})).isLessThan(NOTHING_IN_MOST_CYCLES);
        assertThat(motions.current()).contains("walk-forward");
    }

    @Test
    void walkMakesNoGarbage() {
        double[] forward = {0.1};

        assertThat(bytesPerCycle(() -> {
                    forward[0] = 0.4 - forward[0];
                    walk.towards(forward[0], 0.01, 5);
                }))
                .isLessThan(NOTHING_IN_MOST_CYCLES);
        assertThat(walk.isWalking()).isTrue();
    }

    private double bytesPerCycle(Runnable think) {
        cycles(CYCLES_TO_SETTLE, think);
        com.sun.management.ThreadMXBean threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        long self = Thread.currentThread().getId();
        long before = threads.getThreadAllocatedBytes(self);
        cycles(CYCLES, think);
        return (threads.getThreadAllocatedBytes(self) - before) / (double) CYCLES;
    }

    private void cycles(int count, Runnable think) {
        for (int i = 0; i < count; i++) {
            session.sense();
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
        public void send(MessageBuffer commands) {}

        @Override
        public boolean isLate() {
            return false;
        }

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

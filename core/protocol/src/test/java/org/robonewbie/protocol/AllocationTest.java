package org.robonewbie.protocol;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Joint;
import org.robonewbie.protocol.effector.EffectorMessageReader;
import org.robonewbie.protocol.effector.EffectorMessageWriter;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PerceptorMessageReader;
import org.robonewbie.protocol.perceptor.PerceptorMessageWriter;
import org.robonewbie.protocol.sexp.SexpReader;
import org.robonewbie.protocol.sexp.Token;

/** How much a cycle allocates, measured by the JVM. */
class AllocationTest {

    private static final int ROUNDS = 60;

    private final ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    private final List<MessageBuffer> recorded = RecordedMessages.load("a_agent_two_teams_hear_playon_noise").stream()
            .map(AllocationTest::buffer)
            .toList();

    @Test
    void tokensAndNumbersMakeNoGarbage() {
        SexpReader reader = new SexpReader();

        double bytes = bytesPerMessage(message -> {
            reader.start(message);
            while (reader.next() != Token.END) {
                if (reader.token() == Token.ATOM) {
                    reader.number();
                }
            }
        });

        assertThat(bytes).isLessThan(1);
    }

    @Test
    void readingAllocatesLittleMoreThanTheRecords() {
        PerceptorMessageReader reader = new PerceptorMessageReader();

        double bytes = bytesPerMessage(reader::read);

        assertThat(bytes).isLessThan(4000);
    }

    @Test
    void writingPerceptorsMakesNoGarbage() {
        PerceptorMessageReader reader = new PerceptorMessageReader();
        List<PerceptorMessage> messages = recorded.stream().map(reader::read).toList();
        MessageBuffer buffer = new MessageBuffer(1 << 16);
        PerceptorMessageWriter writer = new PerceptorMessageWriter(buffer);
        int[] next = {0};

        double bytes = bytesPerMessage(ignored -> {
            buffer.clear();
            writer.write(messages.get(next[0]++ % messages.size()));
        });

        assertThat(bytes).isLessThan(1);
    }

    @Test
    void writingEffectorsMakesNoGarbage() {
        MessageBuffer buffer = new MessageBuffer();
        EffectorMessageWriter writer = new EffectorMessageWriter(buffer);
        Joint[] joints = Joint.values();

        double bytes = bytesPerMessage(ignored -> {
            buffer.clear();
            writeSpeeds(writer, joints);
        });

        assertThat(bytes).isLessThan(1);
    }

    @Test
    void readingEffectorsAllocatesOneRecordPerJoint() {
        MessageBuffer buffer = new MessageBuffer();
        writeSpeeds(new EffectorMessageWriter(buffer), Joint.values());
        EffectorMessageReader reader = new EffectorMessageReader();

        double bytes = bytesPerMessage(ignored -> reader.read(buffer, command -> {}, problem -> {}));

        assertThat(bytes).isLessThanOrEqualTo(22 * 32);
    }

    private static void writeSpeeds(EffectorMessageWriter writer, Joint[] joints) {
        for (Joint joint : joints) {
            writer.hingeSpeed(joint.effectorName(), 0.123456789 * joint.ordinal() - 1);
        }
        writer.synchronise();
    }

    private double bytesPerMessage(Consumer<MessageBuffer> action) {
        run(action);
        long before = threads.getCurrentThreadAllocatedBytes();
        run(action);
        long after = threads.getCurrentThreadAllocatedBytes();
        return (after - before) / (double) (ROUNDS * recorded.size());
    }

    private void run(Consumer<MessageBuffer> action) {
        for (int round = 0; round < ROUNDS; round++) {
            for (int i = 0; i < recorded.size(); i++) {
                action.accept(recorded.get(i));
            }
        }
    }

    private static MessageBuffer buffer(String text) {
        MessageBuffer buffer = new MessageBuffer();
        buffer.append(text);
        return buffer;
    }
}

package org.robonewbie.protocol.perceptor;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Joint;
import org.robonewbie.protocol.RecordedMessages;
import org.robonewbie.protocol.frame.MessageBuffer;

class PerceptorFuzzTest {

    private static final List<String> RECORDED = RecordedMessages.loadAll();
    private static final String SYNTAX = "() ;\t\n\"'.-+eE0nanHJSee";

    private final PerceptorMessageReader reader = new PerceptorMessageReader();

    @Property
    void bearsAnyBytes(@ForAll byte[] bytes) {
        assertThat(reader.read(message(bytes))).isNotNull();
    }

    @Property(tries = 3000)
    void bearsDamagedMessages(@ForAll long seed) {
        byte[] damaged = damaged(new Random(seed));

        PerceptorMessage message = reader.read(message(damaged));

        PerceptorMessage again = reader.read(written(message));
        assertThat(written(again)).hasToString(written(message).toString());
    }

    @Test
    void bearsEveryBeginningOfAMessage() {
        byte[] whole = RECORDED.get(2).getBytes(StandardCharsets.US_ASCII);
        MessageBuffer buffer = message(whole);
        int joints = 0;
        for (int length = 0; length <= whole.length; length++) {
            buffer.resize(length);

            int present = (int) Arrays.stream(Joint.values())
                    .filter(reader.read(buffer).jointAngles()::has)
                    .count();

            assertThat(present).isBetween(joints, joints + 1);
            joints = present;
        }
        assertThat(joints).isEqualTo(22);
    }

    @Test
    void bearsDeepNesting() {
        MessageBuffer buffer = new MessageBuffer();
        buffer.append("(See ".repeat(100_000));
        buffer.append("(time (now 5.00))");

        assertThat(reader.read(buffer).seconds()).isEmpty();
    }

    @Test
    void bearsFloodsOfWords() {
        MessageBuffer buffer = new MessageBuffer();
        for (int i = 0; i < 100_000; i++) {
            buffer.append("(hear t" + i + " 1.00 self x)");
        }

        assertThat(reader.read(buffer).heard()).hasSizeLessThanOrEqualTo(100);
    }

    private static byte[] damaged(Random random) {
        byte[] bytes = RECORDED.get(random.nextInt(RECORDED.size())).getBytes(StandardCharsets.US_ASCII);
        int wounds = 1 + random.nextInt(8);
        for (int i = 0; i < wounds; i++) {
            int at = random.nextInt(bytes.length);
            switch (random.nextInt(3)) {
                case 0 -> bytes[at] = (byte) random.nextInt(256);
                case 1 -> bytes[at] = (byte) SYNTAX.charAt(random.nextInt(SYNTAX.length()));
                default -> bytes = cut(bytes, at, at + random.nextInt(bytes.length - at));
            }
            if (bytes.length == 0) {
                return bytes;
            }
        }
        return bytes;
    }

    private static byte[] cut(byte[] bytes, int from, int to) {
        byte[] rest = new byte[bytes.length - (to - from)];
        System.arraycopy(bytes, 0, rest, 0, from);
        System.arraycopy(bytes, to, rest, from, bytes.length - to);
        return rest;
    }

    private static MessageBuffer message(byte[] bytes) {
        MessageBuffer buffer = new MessageBuffer();
        buffer.resize(bytes.length);
        System.arraycopy(bytes, 0, buffer.bytes(), 0, bytes.length);
        return buffer;
    }

    private static MessageBuffer written(PerceptorMessage message) {
        MessageBuffer buffer = new MessageBuffer();
        new PerceptorMessageWriter(buffer).write(message);
        return buffer;
    }
}

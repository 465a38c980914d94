package org.robonewbie.protocol.tcp;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.channels.ReadableByteChannel;
import java.nio.channels.WritableByteChannel;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import org.junit.jupiter.api.Test;
import org.robonewbie.protocol.frame.MessageBuffer;

class FrameTest {

    private static final int LIMIT = 100_000;

    @Test
    void putsTheLengthBeforeTheMessage() throws IOException {
        ByteArrayOutputStream stream = new ByteArrayOutputStream();

        new FrameOutput(stream).write(message("(syn)"));

        assertThat(stream.toByteArray()).containsExactly(0, 0, 0, 5, '(', 's', 'y', 'n', ')');
    }

    @Test
    void writesPrefixAndMessageAtOnce() throws IOException {
        List<Integer> writes = new ArrayList<>();
        FrameOutput output = new FrameOutput(new OutputStream() {
            @Override
            public void write(int single) {
                writes.add(1);
            }

            @Override
            public void write(byte[] bytes, int offset, int length) {
                writes.add(length);
            }
        });

        output.write(message("(syn)"));
        output.write(message(""));

        assertThat(writes).containsExactly(9, 4);
    }

    @Property(tries = 200)
    void readsWhatWasWritten(@ForAll @Size(max = 5) List<@IntRange(max = 70_000) Integer> lengths) throws IOException {
        ByteArrayOutputStream stream = new ByteArrayOutputStream();
        FrameOutput output = new FrameOutput(stream);
        for (int length : lengths) {
            output.write(randomMessage(length));
        }

        FrameInput input = new FrameInput(new ByteArrayInputStream(stream.toByteArray()), LIMIT);

        MessageBuffer read = new MessageBuffer();
        for (int length : lengths) {
            assertThat(input.read(read)).isTrue();
            assertThat(read).hasToString(randomMessage(length).toString());
        }
        assertThat(input.read(read)).isFalse();
    }

    @Test
    void refusesFramesThatAreTooLong() {
        byte[] fourGibibytes = {-1, -1, -1, -1, 0};
        FrameInput input = new FrameInput(new ByteArrayInputStream(fourGibibytes), LIMIT);

        assertThatThrownBy(() -> input.read(new MessageBuffer()))
                .isInstanceOf(FrameTooLongException.class)
                .hasMessage(
                        "The other side announced a message of 4294967295 bytes, more than the 100000 bytes allowed."
                                + " Does it use SimSpark's protocol, with a length of four bytes before each message?");
    }

    @Test
    void noticesAConnectionThatEndsInAMessage() {
        FrameInput inPrefix = new FrameInput(new ByteArrayInputStream(new byte[] {0, 0}), LIMIT);
        FrameInput inMessage = new FrameInput(new ByteArrayInputStream(new byte[] {0, 0, 0, 2, '('}), LIMIT);

        assertThatThrownBy(() -> inPrefix.read(new MessageBuffer()))
                .isInstanceOf(EOFException.class)
                .hasMessage("The other side closed the connection in the middle of a message.");
        assertThatThrownBy(() -> inMessage.read(new MessageBuffer())).isInstanceOf(EOFException.class);
    }

    @Property(tries = 200)
    void decodesMessagesHoweverTheyAreCut(
            @ForAll @Size(min = 1, max = 20) List<@IntRange(max = 40_000) Integer> lengths, @ForAll long seed)
            throws IOException {
        ByteArrayOutputStream stream = new ByteArrayOutputStream();
        FrameOutput output = new FrameOutput(stream);
        for (int length : lengths) {
            output.write(randomMessage(length));
        }
        FrameDecoder decoder = new FrameDecoder(LIMIT);
        ReadableByteChannel channel = new CutChannel(stream.toByteArray(), new Random(seed));

        List<Integer> decoded = new ArrayList<>();
        MessageBuffer message = new MessageBuffer();
        while (decoder.fillFrom(channel) >= 0) {
            while (decoder.next(message)) {
                decoded.add(message.length());
                assertThat(message).hasToString(randomMessage(message.length()).toString());
            }
        }

        assertThat(decoded).isEqualTo(lengths);
    }

    @Test
    void decoderRefusesFramesThatAreTooLongBeforeTheyArrive() throws IOException {
        FrameDecoder decoder = new FrameDecoder(LIMIT);
        decoder.fillFrom(new CutChannel(new byte[] {0, 16, 0, 0}, new Random(1)));

        assertThatThrownBy(() -> {
                    while (!decoder.next(new MessageBuffer())) {
                        decoder.fillFrom(new CutChannel(new byte[] {0, 16, 0, 0}, new Random(1)));
                    }
                })
                .isInstanceOf(FrameTooLongException.class);
    }

    @Test
    void encoderThrowsMessagesAwayWhileOneIsUnderWay() throws IOException {
        NarrowChannel channel = new NarrowChannel();
        FrameEncoder encoder = new FrameEncoder();

        boolean first = encoder.send(channel, message("(one)"));
        boolean second = encoder.send(channel, message("(two)"));
        encoder.flush(channel);
        boolean third = encoder.send(channel, message("(3)"));
        encoder.flush(channel);

        assertThat(first).isTrue();
        assertThat(second).isFalse();
        assertThat(third).isTrue();
        assertThat(encoder.isPending()).isFalse();
        assertThat(channel.received.toByteArray())
                .containsExactly(0, 0, 0, 5, '(', 'o', 'n', 'e', ')', 0, 0, 0, 3, '(', '3', ')');
    }

    private static MessageBuffer message(String text) {
        MessageBuffer message = new MessageBuffer();
        message.append(text);
        return message;
    }

    private static MessageBuffer randomMessage(int length) {
        MessageBuffer message = new MessageBuffer();
        Random random = new Random(length);
        for (int i = 0; i < length; i++) {
            message.append((byte) (' ' + random.nextInt(95)));
        }
        return message;
    }

    /** Delivers its bytes in pieces of any length. */
    private static final class CutChannel implements ReadableByteChannel {
        private final ByteBuffer bytes;
        private final Random random;

        CutChannel(byte[] bytes, Random random) {
            this.bytes = ByteBuffer.wrap(bytes);
            this.random = random;
        }

        @Override
        public int read(ByteBuffer target) {
            if (!bytes.hasRemaining()) {
                return -1;
            }
            int count = Math.min(random.nextInt(20_000), Math.min(target.remaining(), bytes.remaining()));
            target.put(bytes.slice().limit(count));
            bytes.position(bytes.position() + count);
            return count;
        }

        @Override
        public boolean isOpen() {
            return true;
        }

        @Override
        public void close() {
            // nothing to close
        }
    }

    /** Takes four bytes at a time. */
    private static final class NarrowChannel implements WritableByteChannel {
        private final ByteArrayOutputStream received = new ByteArrayOutputStream();

        @Override
        public int write(ByteBuffer source) {
            int count = Math.min(4, source.remaining());
            for (int i = 0; i < count; i++) {
                received.write(source.get());
            }
            return count;
        }

        @Override
        public boolean isOpen() {
            return true;
        }

        @Override
        public void close() {
            // nothing to close
        }
    }
}

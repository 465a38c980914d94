package org.robonewbie.simulator.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robonewbie.nao.Joint;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PerceptorMessageReader;

/** Messages that come in halves, in heaps, twice, late or not at all. */
@Timeout(120)
class AgentFramesTest {

    @SuppressWarnings("NullAway.Init")
    private LeagueServer server;

    @SuppressWarnings("NullAway.Init")
    private Socket socket;

    @BeforeEach
    void join() throws IOException {
        server = new LeagueServer();
        socket = new Socket(InetAddress.getLoopbackAddress(), server.simulator.agentPort());
        socket.setTcpNoDelay(true);
        exchange("(scene rsg/agent/nao/nao.rsg)(syn)");
        exchange("(init (unum 1)(teamname Stars))(syn)");
        for (int i = 0; i < 10; i++) {
            exchange("(syn)");
        }
    }

    @AfterEach
    void close() throws IOException {
        socket.close();
        server.close();
    }

    @Test
    void halfMessageWaitsForItsOtherHalf() throws IOException {
        byte[] frame = frame("(he1 1)(syn)");
        double before = exchange("(syn)").seconds().orElseThrow();

        socket.getOutputStream().write(frame, 0, 7);
        socket.getOutputStream().flush();
        socket.getOutputStream().write(frame, 7, frame.length - 7);
        PerceptorMessage next = receive();
        exchange("(syn)");
        PerceptorMessage last = exchange("(syn)");

        assertThat(next.seconds().orElseThrow() - before).isCloseTo(0.02, within(1e-9));
        assertThat(neckYaw(last)).isGreaterThan(1);
    }

    @Test
    void severalMessagesOfOneCycleCountInTheirOrder() throws IOException {
        double before = exchange("(syn)").seconds().orElseThrow();

        send("(he1 3)(he2 0.5)", "(he1 -1)", "(syn)");
        PerceptorMessage next = receive();
        exchange("(he1 0)(he2 0)(syn)");
        PerceptorMessage last = exchange("(syn)");

        assertThat(next.seconds().orElseThrow() - before).isCloseTo(0.02, within(1e-9));
        assertThat(neckYaw(last)).isCloseTo(-Math.toDegrees(0.02), within(0.2));
        assertThat(last.jointAngles().degreesOr(Joint.NECK_PITCH, 99)).isCloseTo(Math.toDegrees(0.01), within(0.2));
    }

    @Test
    void messageThatComesTwiceDoesNothingTwice() throws IOException {
        PerceptorMessage before = exchange("(syn)");

        send("(beam -5 2 0)(he1 1)(syn)", "(beam -5 2 0)(he1 1)(syn)");
        PerceptorMessage next = receive();
        exchange("(he1 0)(syn)");
        PerceptorMessage last = exchange("(syn)");

        assertThat(next.seconds().orElseThrow() - before.seconds().orElseThrow())
                .isCloseTo(0.02, within(1e-9));
        assertThat(neckYaw(last)).isCloseTo(Math.toDegrees(0.02), within(0.2));
    }

    @Test
    void speedStaysUntilTheNextCommand() throws IOException {
        exchange("(he1 1)(syn)");

        for (int i = 0; i < 11; i++) {
            exchange("(syn)");
        }

        assertThat(neckYaw(exchange("(syn)"))).isCloseTo(Math.toDegrees(0.02 * 12), within(0.5));
    }

    @Test
    void emptyMessageIsOneWithoutCommands() throws IOException {
        double before = exchange("(syn)").seconds().orElseThrow();

        send("", "(syn)");

        assertThat(receive().seconds().orElseThrow() - before).isCloseTo(0.02, within(1e-9));
        assertThat(server.console.sentences()).isEmpty();
    }

    private PerceptorMessage exchange(String text) throws IOException {
        send(text);
        return receive();
    }

    private void send(String... texts) throws IOException {
        ByteArrayOutputStream frames = new ByteArrayOutputStream();
        for (String text : texts) {
            frames.write(frame(text));
        }
        socket.getOutputStream().write(frames.toByteArray());
    }

    private static byte[] frame(String text) {
        byte[] bytes = text.getBytes(StandardCharsets.US_ASCII);
        return ByteBuffer.allocate(4 + bytes.length)
                .putInt(bytes.length)
                .put(bytes)
                .array();
    }

    private PerceptorMessage receive() throws IOException {
        DataInputStream in = new DataInputStream(socket.getInputStream());
        MessageBuffer message = new MessageBuffer();
        message.resize(in.readInt());
        in.readFully(message.bytes(), 0, message.length());
        return new PerceptorMessageReader().read(message);
    }

    private static double neckYaw(PerceptorMessage message) {
        return message.jointAngles().degreesOr(Joint.NECK_YAW, 999);
    }
}

package org.robonewbie.protocol.tcp;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;

@Timeout(120)
class TcpAgentLinkTest {

    private static final String HOST = "127.0.0.1";

    private final ExecutorService executor = Executors.newSingleThreadExecutor();
    private final ServerSocket server;

    TcpAgentLinkTest() throws IOException {
        server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
    }

    @AfterEach
    void stop() throws IOException {
        server.close();
        executor.shutdownNow();
    }

    @Test
    void exchangesMessages() throws IOException {
        try (AgentLink link = TcpAgentLink.connect(HOST, server.getLocalPort());
                Socket peer = server.accept()) {
            link.send(message("(scene x)(syn)"));
            MessageBuffer received = new MessageBuffer();
            new FrameInput(peer.getInputStream(), 1000).read(received);
            assertThat(received).hasToString("(scene x)(syn)");

            new FrameOutput(peer.getOutputStream()).write(message("(time (now 0.02))"));
            assertThat(link.receive(received)).isTrue();
            assertThat(received).hasToString("(time (now 0.02))");
        }
    }

    @Test
    void noticesThatTheSimulatorHasEnded() throws IOException {
        try (AgentLink link = TcpAgentLink.connect(HOST, server.getLocalPort())) {
            server.accept().close();

            assertThat(link.receive(new MessageBuffer())).isFalse();
        }
    }

    @Test
    void canBeClosedWhileSomebodyWaits() throws Exception {
        AgentLink link = TcpAgentLink.connect(HOST, server.getLocalPort());
        try (Socket peer = server.accept()) {
            Future<Boolean> waiting = executor.submit(() -> link.receive(new MessageBuffer()));
            new FrameOutput(peer.getOutputStream()).write(message("(time (now 0.02))"));
            assertThat(waiting.get(120, TimeUnit.SECONDS)).isTrue();

            Future<Boolean> stillWaiting = executor.submit(() -> link.receive(new MessageBuffer()));
            link.close();
            link.close();

            assertThat(stillWaiting.get(120, TimeUnit.SECONDS)).isFalse();
        }
    }

    @Test
    void reportsAConnectionThatIsReset() throws IOException {
        try (AgentLink link = TcpAgentLink.connect(HOST, server.getLocalPort())) {
            Socket peer = server.accept();
            peer.setSoLinger(true, 0);
            peer.close();

            assertThatThrownBy(() -> link.receive(new MessageBuffer()))
                    .isInstanceOf(IOException.class)
                    .hasMessageStartingWith("The connection to the simulator was lost")
                    .hasMessageEndingWith("Was it stopped?");
        }
    }

    @Test
    void saysWhatToDoWhenNobodyListens() throws IOException {
        int port = server.getLocalPort();
        server.close();

        assertThatThrownBy(() -> TcpAgentLink.connect(HOST, port))
                .isInstanceOf(IOException.class)
                .hasMessage(
                        "No simulator answers at 127.0.0.1:" + port + ". Start one with \"robonewbie simulator\", or"
                                + " omit the host to start one automatically.");
    }

    @Test
    void saysThatAHostIsUnknown() {
        assertThatThrownBy(() -> TcpAgentLink.connect("no.such.host.invalid", 3100))
                .isInstanceOf(IOException.class)
                .hasMessage("No computer named \"no.such.host.invalid\" can be found. Check the host name.");
    }

    @Test
    void refusesPeersThatDoNotSpeakTheProtocol() throws IOException {
        try (AgentLink link = TcpAgentLink.connect(HOST, server.getLocalPort());
                Socket peer = server.accept()) {
            peer.getOutputStream().write("HTTP/1.1 400 Bad Request\r\n".getBytes(StandardCharsets.US_ASCII));

            assertThatThrownBy(() -> link.receive(new MessageBuffer()))
                    .isInstanceOf(FrameTooLongException.class)
                    .hasMessageContaining("Does it use SimSpark's protocol");
        }
    }

    private static MessageBuffer message(String text) {
        MessageBuffer message = new MessageBuffer();
        message.append(text);
        return message;
    }
}

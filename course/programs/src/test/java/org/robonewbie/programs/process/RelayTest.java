package org.robonewbie.programs.process;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetAddress;
import java.net.Socket;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

@Timeout(60)
class RelayTest {

    @TempDir
    private Path folder;

    @Test
    void bytesPassInBothDirectionsUntilOneEndCloses() throws Exception {
        Path door = folder.resolve("door");
        try (ServerSocketChannel server = ServerSocketChannel.open(StandardProtocolFamily.UNIX)) {
            server.bind(UnixDomainSocketAddress.of(door));
            int port = Relay.open(0, door);
            try (Socket program = new Socket(InetAddress.getLoopbackAddress(), port);
                    SocketChannel simulator = server.accept()) {
                program.getOutputStream().write(42);
                ByteBuffer received = ByteBuffer.allocate(1);
                simulator.read(received);
                simulator.write(received.flip());

                int back = program.getInputStream().read();
                simulator.shutdownOutput();
                int end = program.getInputStream().read();

                assertThat(back).isEqualTo(42);
                assertThat(end).isEqualTo(-1);
            }
        }
    }

    @Test
    void connectionWithoutASimulatorIsClosed() throws Exception {
        int port = Relay.open(0, folder.resolve("missing"));

        try (Socket program = new Socket(InetAddress.getLoopbackAddress(), port)) {
            assertThat(program.getInputStream().read()).isEqualTo(-1);
        }
    }
}

package org.robonewbie.studio.league;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robonewbie.protocol.embedded.SimulatorRequest;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.embedded.ViewedSimulator;
import org.robonewbie.simulator.embedded.Viewer;

@Timeout(60)
class LeagueSimulatorTest {

    private static final byte[] MESSAGE = "((RSMP 1 0)((gt 1 0)0.04))".getBytes(StandardCharsets.US_ASCII);

    @Test
    void stopsWatchingTheMatchIfTheStudioDoesNotOpen() throws Exception {
        try (ServerSocket monitorPort = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            CompletableFuture<Boolean> closed = CompletableFuture.supplyAsync(() -> isClosedByItsClient(monitorPort));

            LeagueSimulator simulator = new LeagueSimulator(0, monitorPort.getLocalPort(), "Test", Optional.empty());
            assertThatThrownBy(() -> ViewedSimulator.open(simulator, request(), Optional.of(new NoViewer())))
                    .hasMessage("no port");

            assertThat(closed.get()).isTrue();
        }
    }

    /** Sends one message to the first client and waits until it closes the connection. */
    private static boolean isClosedByItsClient(ServerSocket port) {
        try (Socket client = port.accept()) {
            DataInputStream in = new DataInputStream(client.getInputStream());
            in.readNBytes(in.readInt());
            DataOutputStream out = new DataOutputStream(client.getOutputStream());
            out.writeInt(MESSAGE.length);
            out.write(MESSAGE);
            return in.read() == -1;
        } catch (IOException broken) {
            return false;
        }
    }

    private static SimulatorRequest request() {
        return new SimulatorRequest(
                "T1",
                60000,
                OptionalLong.empty(),
                false,
                OptionalDouble.empty(),
                false,
                false,
                false,
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                1,
                "Test");
    }

    /** A viewer that cannot be opened. */
    private static final class NoViewer implements Viewer {
        @Override
        public View open(SimulationControl simulation, int port) throws IOException {
            throw new IOException("no port");
        }
    }
}

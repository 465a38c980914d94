package org.robonewbie.app.doctor;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;

/** Checks whether a TCP port is free; if it is not, guesses what is listening on it. */
final class PortCheck {

    private static final int MILLISECONDS = 500;
    private static final int FIRST_BYTES = 64;

    private PortCheck() {}

    static Finding of(String subject, int port) {
        try (ServerSocket socket = new ServerSocket()) {
            socket.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), port));
            return Finding.well(subject, port + " is free");
        } catch (IOException inUse) {
            return Finding.notable(
                    subject,
                    port + " is in use by " + listenerAt(port),
                    "Agents join the simulator that runs there. To start another one, stop that program or use another port.");
        }
    }

    /**
     * Guesses what is listening: a soccer server sends its scene to monitors immediately, but waits for agents to send
     * the first message.
     */
    private static String listenerAt(int port) {
        try (Socket socket = new Socket()) {
            socket.connect(new InetSocketAddress(InetAddress.getLoopbackAddress(), port), MILLISECONDS);
            socket.setSoTimeout(MILLISECONDS);
            String answer = new String(socket.getInputStream().readNBytes(FIRST_BYTES), StandardCharsets.ISO_8859_1);
            return answer.contains("((") ? "a soccer simulator" : "another program";
        } catch (IOException silent) {
            return "a program that waits for a client to speak first, as a soccer simulator does";
        }
    }
}

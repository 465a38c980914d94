package org.robonewbie.app.doctor;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;

/** Looks whether a port of this computer is free, and else who answers there. */
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
                    port + " is in use by " + whoAnswers(port),
                    "Agents join a simulator that runs there. To have your own, end that program or use another port.");
        }
    }

    /** A soccer server sends its scene to monitors unasked and says nothing to agents that say nothing. */
    private static String whoAnswers(int port) {
        try (Socket socket = new Socket()) {
            socket.connect(new InetSocketAddress(InetAddress.getLoopbackAddress(), port), MILLISECONDS);
            socket.setSoTimeout(MILLISECONDS);
            String answer = new String(socket.getInputStream().readNBytes(FIRST_BYTES), StandardCharsets.ISO_8859_1);
            return answer.contains("((") ? "a soccer simulator" : "another program";
        } catch (IOException silent) {
            return "a program that waits for others to speak, as a soccer simulator does";
        }
    }
}

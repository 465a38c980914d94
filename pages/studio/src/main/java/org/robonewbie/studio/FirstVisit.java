package org.robonewbie.studio;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;

/**
 * Asks the studio for its start page while the browser of the person still starts, since Java is slow at everything that it
 * does first.
 */
final class FirstVisit {

    private FirstVisit() {}

    /** Starts the visit in the background. */
    static void start(WebFiles files, int port) {
        Thread visitor = new Thread(() -> visit(files, port), "studio-first-visit");
        visitor.setDaemon(true);
        visitor.start();
    }

    private static void visit(WebFiles files, int port) {
        files.warmUp();
        try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
            String request = "GET / HTTP/1.1\r\nHost: 127.0.0.1:" + port + "\r\nConnection: close\r\n\r\n";
            socket.getOutputStream().write(request.getBytes(StandardCharsets.US_ASCII));
            socket.getInputStream().readAllBytes();
        } catch (IOException closedMeanwhile) {
            // The user's own visit will then be the first one.
        }
    }
}

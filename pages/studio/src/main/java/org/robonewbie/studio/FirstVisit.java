package org.robonewbie.studio;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;

/**
 * Requests the start page while the user's browser is still starting, so that the server's classes are loaded before
 * the browser connects.
 */
final class FirstVisit {

    private FirstVisit() {}

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
            // The warm-up is optional.
        }
    }
}

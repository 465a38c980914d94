package org.robonewbie.studio;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.URI;
import java.nio.charset.StandardCharsets;

/** Sends a request verbatim, including requests that no HTTP client would send. */
final class RawHttp {

    private RawHttp() {}

    /**
     * Sends request lines, followed by a Connection: close header.
     *
     * @return the whole response
     */
    static String send(URI server, String... lines) throws IOException {
        return sendText(server, String.join("\r\n", lines) + "\r\nConnection: close\r\n\r\n");
    }

    /** Sends a complete request. */
    static String sendText(URI server, String request) throws IOException {
        try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.getPort())) {
            socket.getOutputStream().write(request.getBytes(StandardCharsets.UTF_8));
            return new String(socket.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        }
    }
}

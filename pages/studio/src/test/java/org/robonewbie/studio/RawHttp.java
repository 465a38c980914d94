package org.robonewbie.studio;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.URI;
import java.nio.charset.StandardCharsets;

/** Sends a request exactly as it is written, also one that no decent client would send. */
final class RawHttp {

    private RawHttp() {}

    /**
     * Sends request lines, and a closing Connection header.
     *
     * @return the whole answer
     */
    static String send(URI server, String... lines) throws IOException {
        return sendText(server, String.join("\r\n", lines) + "\r\nConnection: close\r\n\r\n");
    }

    /** Sends a whole request to its last character. */
    static String sendText(URI server, String request) throws IOException {
        try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.getPort())) {
            socket.getOutputStream().write(request.getBytes(StandardCharsets.UTF_8));
            return new String(socket.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        }
    }
}

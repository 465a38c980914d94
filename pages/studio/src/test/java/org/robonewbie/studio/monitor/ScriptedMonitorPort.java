package org.robonewbie.studio.monitor;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;

/**
 * A port that collects what its first client sends. It answers the client's first message with the first of its script and the second
 * message with all the others. Without a script, it closes the connection after the first message.
 */
final class ScriptedMonitorPort implements AutoCloseable {

    final BlockingQueue<String> received = new LinkedBlockingQueue<>();
    private final ServerSocket port = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
    private final List<String> messages;

    ScriptedMonitorPort(List<String> messages) throws IOException {
        this.messages = messages;
        Thread thread = new Thread(this::serve, "scripted-monitor-port");
        thread.setDaemon(true);
        thread.start();
    }

    int number() {
        return port.getLocalPort();
    }

    private void serve() {
        try (Socket client = port.accept()) {
            DataOutputStream out = new DataOutputStream(client.getOutputStream());
            DataInputStream in = new DataInputStream(client.getInputStream());
            received.add(read(in));
            if (messages.isEmpty()) {
                return;
            }
            send(messages.get(0), out);
            received.add(read(in));
            for (String message : messages.subList(1, messages.size())) {
                send(message, out);
            }
            while (true) {
                received.add(read(in));
            }
        } catch (IOException closed) {
            // The client has left.
        }
    }

    private static String read(DataInputStream in) throws IOException {
        return new String(in.readNBytes(in.readInt()), StandardCharsets.UTF_8);
    }

    private static void send(String message, DataOutputStream out) throws IOException {
        byte[] bytes = message.getBytes(StandardCharsets.UTF_8);
        out.writeInt(bytes.length);
        out.write(bytes);
    }

    @Override
    public void close() throws IOException {
        port.close();
    }
}

package org.robonewbie.agent;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PerceptorMessageWriter;
import org.robonewbie.protocol.tcp.FrameInput;
import org.robonewbie.protocol.tcp.FrameOutput;

/** A server for one client on a real port. It answers each message with the next of its script; then it closes. */
final class ScriptedServer implements AutoCloseable {

    private final ServerSocket socket = new ServerSocket(0, 10, InetAddress.getLoopbackAddress());
    private final List<PerceptorMessage> script;
    private final List<String> received = Collections.synchronizedList(new ArrayList<>());
    private final Thread thread = new Thread(this::serve, "scripted server");

    ScriptedServer(List<PerceptorMessage> script) throws IOException {
        this.script = script;
        thread.setDaemon(true);
        thread.start();
    }

    int port() {
        return socket.getLocalPort();
    }

    /** All messages of the client, in their order. */
    List<String> received() {
        return List.copyOf(received);
    }

    /** Waits until the script has been played or the client has left. */
    void await() throws InterruptedException {
        thread.join(100_000);
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }

    private void serve() {
        try (Socket client = socket.accept()) {
            play(client);
        } catch (IOException end) {
            // the test is over
        }
    }

    private void play(Socket client) throws IOException {
        FrameInput input = new FrameInput(client.getInputStream(), 1 << 20);
        FrameOutput output = new FrameOutput(client.getOutputStream());
        MessageBuffer buffer = new MessageBuffer();
        for (PerceptorMessage message : script) {
            if (!input.read(buffer)) {
                return;
            }
            received.add(buffer.toString());
            buffer.clear();
            new PerceptorMessageWriter(buffer).write(message);
            output.write(buffer);
        }
        if (input.read(buffer)) {
            received.add(buffer.toString());
        }
    }
}

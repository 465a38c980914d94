package org.robonewbie.agent;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PerceptorMessageWriter;
import org.robonewbie.protocol.tcp.FrameInput;
import org.robonewbie.protocol.tcp.FrameOutput;

/**
 * A server on a real port. It answers each message of a client with the next of its script; then it closes the connection. Like a
 * simulator, it can hold its first cycle until some clients have spoken.
 */
final class ScriptedServer implements AutoCloseable {

    private final ServerSocket socket = new ServerSocket(0, 10, InetAddress.getLoopbackAddress());
    private final List<PerceptorMessage> script;
    private final CountDownLatch missing;
    private final List<Heard> heard = Collections.synchronizedList(new ArrayList<>());
    private final Thread firstClient = new Thread(() -> serve(1), "scripted server");

    ScriptedServer(List<PerceptorMessage> script) throws IOException {
        this(script, 0);
    }

    ScriptedServer(List<PerceptorMessage> script, int awaitedClients) throws IOException {
        this.script = script;
        this.missing = new CountDownLatch(awaitedClients);
        firstClient.setDaemon(true);
        firstClient.start();
    }

    /** A message of a client, which are numbered from 1 in the order in which they connected. */
    record Heard(int client, String message) {}

    int port() {
        return socket.getLocalPort();
    }

    /** All messages of the first client, in their order. */
    List<String> received() {
        return heard().stream()
                .filter(each -> each.client() == 1)
                .map(Heard::message)
                .toList();
    }

    /** The messages of all clients, in their order. */
    List<Heard> heard() {
        synchronized (heard) {
            return List.copyOf(heard);
        }
    }

    /** Waits until the script has been played for the first client or it has left. */
    void await() throws InterruptedException {
        firstClient.join(100_000);
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }

    private void serve(int number) {
        try (Socket client = socket.accept()) {
            Thread next = new Thread(() -> serve(number + 1), "scripted server");
            next.setDaemon(true);
            next.start();
            play(client, number);
        } catch (IOException | InterruptedException end) {
            // the test is over
        }
    }

    private void play(Socket client, int number) throws IOException, InterruptedException {
        FrameInput input = new FrameInput(client.getInputStream(), 1 << 20);
        FrameOutput output = new FrameOutput(client.getOutputStream());
        MessageBuffer buffer = new MessageBuffer();
        for (PerceptorMessage message : script) {
            if (!input.read(buffer)) {
                return;
            }
            heard.add(new Heard(number, buffer.toString()));
            missing.countDown();
            missing.await();
            buffer.clear();
            new PerceptorMessageWriter(buffer).write(message);
            output.write(buffer);
        }
        if (input.read(buffer)) {
            heard.add(new Heard(number, buffer.toString()));
        }
    }
}

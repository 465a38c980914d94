package org.robonewbie.protocol.tcp;

import java.io.BufferedReader;
import java.io.BufferedWriter;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStreamWriter;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.robonewbie.protocol.telemetry.TelemetryLine;
import org.robonewbie.protocol.telemetry.TelemetryMessage;
import org.robonewbie.protocol.telemetry.TelemetrySink;
import org.robonewbie.protocol.telemetry.TuningRequest;
import org.robonewbie.protocol.telemetry.TuningRequests;

/**
 * Sends telemetry to a {@link TelemetryServer} on this computer and receives its tuning requests. A background thread sends the
 * messages, so that robots never block. Messages are dropped if no server is connected or the server is too slow. While
 * disconnected, the client tries to connect every two seconds.
 */
public final class TelemetryClient implements TelemetrySink, AutoCloseable {

    private static final int CAPACITY = 10_000;
    private static final long RETRY_SECONDS = 2;
    private static final long POLL_MILLISECONDS = 50;
    private static final long CLOSE_MILLISECONDS = 500;

    private final int port;
    private final BlockingQueue<TelemetryMessage> queue = new ArrayBlockingQueue<>(CAPACITY);
    private final TuningRequests tuningRequests = new TuningRequests();
    private final CountDownLatch closing = new CountDownLatch(1);
    private final Thread thread = new Thread(this::work, "telemetry");
    private volatile boolean connected;

    private TelemetryClient(int port) {
        this.port = port;
    }

    /**
     * Starts a client, which connects in the background.
     *
     * @param port TCP port on 127.0.0.1, see {@link TelemetryServer#portFor}
     * @return the client
     */
    public static TelemetryClient open(int port) {
        TelemetryClient client = new TelemetryClient(port);
        start(client.thread);
        return client;
    }

    @Override
    public void accept(TelemetryMessage message) {
        if (connected && !queue.offer(message)) {
            queue.poll(); // drop the oldest message
            queue.offer(message);
        }
    }

    @Override
    public boolean isWanted() {
        return connected;
    }

    @Override
    public Optional<TuningRequests> tuningRequests() {
        return Optional.of(tuningRequests);
    }

    /** Spends at most half a second sending the remaining messages, then closes the connection. */
    @Override
    public void close() {
        closing.countDown();
        try {
            thread.join(CLOSE_MILLISECONDS);
        } catch (InterruptedException end) {
            Thread.currentThread().interrupt();
        }
    }

    private void work() {
        try {
            do {
                sendUntilDisconnected();
            } while (!closing.await(RETRY_SECONDS, TimeUnit.SECONDS));
        } catch (InterruptedException end) {
            Thread.currentThread().interrupt();
        }
    }

    private void sendUntilDisconnected() throws InterruptedException {
        try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port);
                BufferedWriter writer =
                        new BufferedWriter(new OutputStreamWriter(socket.getOutputStream(), StandardCharsets.UTF_8))) {
            connected = true;
            start(new Thread(() -> receive(socket), "telemetry-tuning"));
            while (closing.getCount() > 0 || !queue.isEmpty()) {
                TelemetryMessage message = queue.poll(POLL_MILLISECONDS, TimeUnit.MILLISECONDS);
                if (message != null) {
                    writer.write(TelemetryLine.write(message));
                    writer.write('\n');
                }
                if (queue.isEmpty()) {
                    writer.flush();
                }
            }
        } catch (IOException unreachable) {
            // the caller tries again later
        } finally {
            connected = false;
            queue.clear();
        }
    }

    /** Receives tuning requests until the connection is closed. */
    private void receive(Socket socket) {
        try (BufferedReader reader =
                new BufferedReader(new InputStreamReader(socket.getInputStream(), StandardCharsets.UTF_8))) {
            for (String line = reader.readLine(); line != null; line = reader.readLine()) {
                TuningRequest.read(line).ifPresent(tuningRequests::put);
            }
        } catch (IOException closed) {
            // the sending thread detects and handles this
        }
    }

    private static void start(Thread thread) {
        thread.setDaemon(true);
        thread.start();
    }
}

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
import org.robonewbie.protocol.telemetry.NumberWish;
import org.robonewbie.protocol.telemetry.NumberWishes;
import org.robonewbie.protocol.telemetry.TelemetryLine;
import org.robonewbie.protocol.telemetry.TelemetryMessage;
import org.robonewbie.protocol.telemetry.TelemetrySink;

/**
 * Sends telemetry to a {@link TelemetryServer} on this computer. A background thread does the sending, so a robot never waits:
 * without a listener nothing is wanted, and what a slow listener cannot take is dropped. It looks for a listener every two
 * seconds, and takes what the listener wants of the robots' numbers.
 */
public final class TelemetryClient implements TelemetrySink, AutoCloseable {

    private static final int CAPACITY = 10_000;
    private static final long RETRY_SECONDS = 2;
    private static final long LOOK_MILLISECONDS = 50;
    private static final long FAREWELL_MILLISECONDS = 500;

    private final int port;
    private final BlockingQueue<TelemetryMessage> queue = new ArrayBlockingQueue<>(CAPACITY);
    private final NumberWishes wishes = new NumberWishes();
    private final CountDownLatch closing = new CountDownLatch(1);
    private final Thread thread = new Thread(this::work, "telemetry");
    private volatile boolean connected;

    private TelemetryClient(int port) {
        this.port = port;
    }

    /**
     * Starts looking for a listener.
     *
     * @param port TCP port on 127.0.0.1, see {@link TelemetryServer#portFor}
     * @return the client, returned at once whether or not there is a listener
     */
    public static TelemetryClient open(int port) {
        TelemetryClient client = new TelemetryClient(port);
        start(client.thread);
        return client;
    }

    @Override
    public void accept(TelemetryMessage message) {
        if (connected && !queue.offer(message)) {
            queue.poll(); // the newest is worth more than the oldest
            queue.offer(message);
        }
    }

    @Override
    public boolean isWanted() {
        return connected;
    }

    @Override
    public Optional<NumberWishes> wishes() {
        return Optional.of(wishes);
    }

    /** Sends what is still waiting, for half a second at most, and closes the connection. */
    @Override
    public void close() {
        closing.countDown();
        try {
            thread.join(FAREWELL_MILLISECONDS);
        } catch (InterruptedException end) {
            Thread.currentThread().interrupt();
        }
    }

    private void work() {
        try {
            do {
                talk();
            } while (!closing.await(RETRY_SECONDS, TimeUnit.SECONDS));
        } catch (InterruptedException end) {
            Thread.currentThread().interrupt();
        }
    }

    private void talk() throws InterruptedException {
        try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port);
                BufferedWriter writer =
                        new BufferedWriter(new OutputStreamWriter(socket.getOutputStream(), StandardCharsets.UTF_8))) {
            connected = true;
            start(new Thread(() -> listen(socket), "telemetry-wishes"));
            while (closing.getCount() > 0 || !queue.isEmpty()) {
                TelemetryMessage message = queue.poll(LOOK_MILLISECONDS, TimeUnit.MILLISECONDS);
                if (message != null) {
                    writer.write(TelemetryLine.write(message));
                    writer.write('\n');
                }
                if (queue.isEmpty()) {
                    writer.flush();
                }
            }
        } catch (IOException nobody) {
            // no listener at present; the next attempt follows
        } finally {
            connected = false;
            queue.clear();
        }
    }

    /** Reads until the connection is closed. */
    private void listen(Socket socket) {
        try (BufferedReader reader =
                new BufferedReader(new InputStreamReader(socket.getInputStream(), StandardCharsets.UTF_8))) {
            for (String line = reader.readLine(); line != null; line = reader.readLine()) {
                NumberWish.read(line).ifPresent(wishes::put);
            }
        } catch (IOException closed) {
            // the sending thread sees it as well
        }
    }

    private static void start(Thread thread) {
        thread.setDaemon(true);
        thread.start();
    }
}

package org.robonewbie.studio;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.ByteArrayOutputStream;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Objects;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;

/** A page without a browser, connected to the studio by a real WebSocket. */
final class TestPage implements AutoCloseable, WebSocket.Listener {

    private static final long PATIENCE_SECONDS = 120;

    private final BlockingQueue<JsonObject> messages = new LinkedBlockingQueue<>();
    private final BlockingQueue<ByteBuffer> frames = new LinkedBlockingQueue<>();
    private final CompletableFuture<Integer> closeCode = new CompletableFuture<>();
    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private final StringBuilder text = new StringBuilder();
    private final WebSocket socket;

    TestPage(URI studio) {
        socket = HttpClient.newHttpClient()
                .newWebSocketBuilder()
                .header("Origin", "http://" + studio.getAuthority())
                .header("Cookie", StudioCookie.of(studio))
                .buildAsync(URI.create("ws://" + studio.getAuthority() + "/live"), this)
                .join();
    }

    JsonObject nextMessage() throws InterruptedException {
        return Objects.requireNonNull(
                messages.poll(PATIENCE_SECONDS, TimeUnit.SECONDS), "no message came from the studio");
    }

    /** Receives messages until the scene matches. */
    JsonObject awaitScene(Predicate<JsonObject> wanted) throws InterruptedException {
        while (true) {
            JsonObject message = messages.poll();
            if (message != null && message.has("robots") && wanted.test(message)) {
                return message;
            }
            if (message == null) {
                nextFrame();
                seen();
            }
        }
    }

    /** Receives frames until the world is paused. */
    long nextPausedCycle() throws InterruptedException {
        ByteBuffer frame = nextFrame();
        while ((frame.get(1) & 1) == 0) {
            seen();
            frame = nextFrame();
        }
        seen();
        return cycleOf(frame);
    }

    /** Receives frames until the world has reached a cycle; does not acknowledge the last one. */
    long nextCycleFrom(long cycle) throws InterruptedException {
        long now = cycleOf(nextFrame());
        while (now < cycle) {
            seen();
            now = cycleOf(nextFrame());
        }
        return now;
    }

    static long cycleOf(ByteBuffer frame) {
        return Integer.toUnsignedLong(frame.getInt(4));
    }

    ByteBuffer nextFrame() throws InterruptedException {
        ByteBuffer frame = frames.poll(PATIENCE_SECONDS, TimeUnit.SECONDS);
        return Objects.requireNonNull(frame, "no frame came from the studio").order(ByteOrder.LITTLE_ENDIAN);
    }

    boolean framesWithin(long milliseconds) throws InterruptedException {
        ByteBuffer frame = frames.poll(milliseconds, TimeUnit.MILLISECONDS);
        return frame != null;
    }

    void seen() {
        send("{\"do\":\"seen\"}");
    }

    void send(String command) {
        socket.sendText(command, true).join();
    }

    int closeCode() throws Exception {
        return closeCode.get(PATIENCE_SECONDS, TimeUnit.SECONDS);
    }

    @Override
    public CompletionStage<?> onText(WebSocket webSocket, CharSequence data, boolean last) {
        text.append(data);
        if (last) {
            messages.add(JsonParser.parseString(text.toString()).getAsJsonObject());
            text.setLength(0);
        }
        webSocket.request(1);
        return CompletableFuture.completedFuture(null);
    }

    @Override
    public CompletionStage<?> onBinary(WebSocket webSocket, ByteBuffer data, boolean last) {
        byte[] part = new byte[data.remaining()];
        data.get(part);
        bytes.writeBytes(part);
        if (last) {
            frames.add(ByteBuffer.wrap(bytes.toByteArray()));
            bytes.reset();
        }
        webSocket.request(1);
        return CompletableFuture.completedFuture(null);
    }

    @Override
    public CompletionStage<?> onClose(WebSocket webSocket, int statusCode, String reason) {
        closeCode.complete(statusCode);
        return CompletableFuture.completedFuture(null);
    }

    @Override
    public void close() {
        socket.abort();
    }
}

package org.robonewbie.studio;

import java.nio.ByteBuffer;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.eclipse.jetty.websocket.api.Callback;
import org.eclipse.jetty.websocket.api.Session;
import org.eclipse.jetty.websocket.api.StatusCode;
import org.jspecify.annotations.Nullable;
import org.robonewbie.simulator.json.Json;
import org.robonewbie.studio.roboviz.RoboVizFeed;

/**
 * WebSocket connection of a page that displays the simulation.
 *
 * <p>The next frame is sent only after the page has acknowledged the previous one, so a frozen or hidden page has at
 * most one frame in flight. An unchanged frame is repeated once per second as a keep-alive while the world is paused.
 */
public final class Spectator extends Session.Listener.AbstractAutoDemanding {

    private static final int MAX_QUEUED = 100;
    private static final long REPEAT_NANOS = TimeUnit.SECONDS.toNanos(1);

    private final LiveFeed feed;
    private final TelemetryFeed telemetry = new TelemetryFeed();
    private final CompletableFuture<Void> closed = new CompletableFuture<>();
    private final Deque<String> queue = new ArrayDeque<>();
    private Optional<UndoManager.Names> sentUndoNames = Optional.empty();
    private int sentDrawings;
    private volatile boolean ready;
    private int sentScene = -1;
    private @Nullable ByteBuffer sentFrame;
    private long sentNanos;

    Spectator(LiveFeed feed) {
        this.feed = feed;
    }

    @Override
    public void onWebSocketOpen(Session session) {
        super.onWebSocketOpen(session);
        ready = true;
        feed.add(this);
    }

    @Override
    public void onWebSocketText(String message) {
        try {
            StudioRequest command = StudioRequestReader.read(message);
            if (command instanceof StudioRequest.Seen) {
                ready = true;
            } else if (command instanceof StudioRequest.Watch watch) {
                telemetry.watch(TelemetryHistory.key(watch.team(), watch.number()));
            } else {
                command.applyTo(feed);
            }
        } catch (RuntimeException e) {
            refuse(e);
        }
    }

    private void refuse(RuntimeException reason) {
        String text = String.valueOf(reason.getMessage());
        getSession().sendText(Json.object("kind", "refused", "text", text).toString(), Callback.NOOP);
    }

    /**
     * Returns the telemetry for this page. Except for {@link TelemetryFeed#watch}, only the feed's thread may use it.
     */
    TelemetryFeed telemetry() {
        return telemetry;
    }

    /** Queues a message until the page is ready. Called by the feed's thread only. */
    void enqueue(String json) {
        queue.add(json);
        if (queue.size() > MAX_QUEUED) {
            queue.remove();
        }
    }

    /** Queues the names of the next commands to undo and redo if they have changed. Called by the feed's thread only. */
    void enqueueUndoNames(UndoManager.Names names) {
        if (!sentUndoNames.equals(Optional.of(names))) {
            sentUndoNames = Optional.of(names);
            enqueue(SceneDescriptionWriter.undoManager(names));
        }
    }

    /** Queues the drawing sets that have changed since the last frame. Called by the feed's thread only. */
    void enqueueDrawings(RoboVizFeed board) {
        int revision = board.revision();
        if (ready && revision > sentDrawings) {
            board.since(sentDrawings).ifPresent(this::enqueue);
            sentDrawings = revision;
        }
    }

    /**
     * Sends a frame, preceded by the scene if it has changed. Does nothing while the page is busy. Called by the feed's thread only.
     */
    void offer(int sceneRevision, String sceneJson, ByteBuffer frame) {
        boolean repeated = frame.equals(sentFrame) && queue.isEmpty();
        if (!ready || (repeated && System.nanoTime() - sentNanos < REPEAT_NANOS)) {
            return;
        }
        ready = false;
        sentFrame = frame;
        sentNanos = System.nanoTime();
        Session session = getSession();
        List<String> texts = new ArrayList<>();
        if (sentScene != sceneRevision) {
            sentScene = sceneRevision;
            texts.add(sceneJson);
        }
        texts.addAll(queue);
        queue.clear();
        telemetry.take().ifPresent(texts::add);
        send(session, texts, frame);
    }

    /** Sends the text messages in order, then the frame. */
    private static void send(Session session, List<String> texts, ByteBuffer frame) {
        if (texts.isEmpty()) {
            session.sendBinary(frame.duplicate(), Callback.NOOP);
            return;
        }
        List<String> others = texts.subList(1, texts.size());
        session.sendText(texts.get(0), Callback.from(() -> send(session, others, frame), failure -> {}));
    }

    /** {@return a future that is completed when the page has confirmed that the connection is closed} */
    CompletableFuture<Void> disconnect() {
        Session session = getSession();
        if (session == null) {
            closed.complete(null);
        } else {
            session.close(StatusCode.SHUTDOWN, "The simulator has ended.", Callback.NOOP);
        }
        return closed;
    }

    @Override
    public void onWebSocketClose(int statusCode, @Nullable String reason, Callback callback) {
        feed.remove(this);
        closed.complete(null);
        callback.succeed();
    }

    @Override
    public void onWebSocketError(Throwable cause) {
        feed.remove(this);
        closed.complete(null);
    }
}

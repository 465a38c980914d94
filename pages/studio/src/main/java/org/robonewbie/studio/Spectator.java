package org.robonewbie.studio;

import com.google.gson.JsonObject;
import java.nio.ByteBuffer;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.eclipse.jetty.websocket.api.Callback;
import org.eclipse.jetty.websocket.api.Session;
import org.eclipse.jetty.websocket.api.StatusCode;
import org.jspecify.annotations.Nullable;
import org.robonewbie.studio.roboviz.RoboVizFeed;

/**
 * A page that watches the simulation.
 *
 * <p>It receives its next frame only after it has reported that the last one was drawn, so a page that is frozen or hidden has
 * at most one frame on its way. A frame that has not changed is repeated once per second, which shows the page that the studio
 * is alive although the world is paused.
 */
public final class Spectator extends Session.Listener.AbstractAutoDemanding {

    private static final int MOST_NEWS = 100;
    private static final long REPEAT_NANOS = TimeUnit.SECONDS.toNanos(1);

    private final LiveFeed feed;
    private final TelemetryFeed telemetry = new TelemetryFeed();
    private final Deque<String> news = new ArrayDeque<>();
    private Optional<UndoManager.Names> toldDeeds = Optional.empty();
    private int toldBoard;
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
        JsonObject json = new JsonObject();
        json.addProperty("kind", "refused");
        json.addProperty("text", String.valueOf(reason.getMessage()));
        getSession().sendText(json.toString(), Callback.NOOP);
    }

    /** What the page hears of robots. Called by the feed's thread only, but for {@link TelemetryFeed#watch}. */
    TelemetryFeed telemetry() {
        return telemetry;
    }

    /** Keeps what has happened in the game until the page is ready for it. Called by the feed's thread only. */
    void tell(String json) {
        news.add(json);
        if (news.size() > MOST_NEWS) {
            news.remove();
        }
    }

    /** Passes on what would be undone and redone, if the page does not know it yet. Called by the feed's thread only. */
    void tellDeeds(UndoManager.Names names) {
        if (!toldDeeds.equals(Optional.of(names))) {
            toldDeeds = Optional.of(names);
            tell(SceneDescriptionWriter.undoManager(names));
        }
    }

    /** Keeps the sets of drawings that have changed since the page has got its last frame. Called by the feed's thread only. */
    void tellDrawings(RoboVizFeed board) {
        int revision = board.revision();
        if (ready && revision > toldBoard) {
            board.since(toldBoard).ifPresent(this::tell);
            toldBoard = revision;
        }
    }

    /**
     * Sends a frame, and before it the scene if the page does not have it yet; does nothing while the page is busy. Called
     * by the feed's thread only.
     */
    void offer(int sceneRevision, String sceneJson, ByteBuffer frame) {
        boolean repeated = frame.equals(sentFrame) && news.isEmpty();
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
        texts.addAll(news);
        news.clear();
        telemetry.take().ifPresent(texts::add);
        send(session, texts, frame);
    }

    /** Sends texts in order, and the frame last. */
    private static void send(Session session, List<String> texts, ByteBuffer frame) {
        if (texts.isEmpty()) {
            session.sendBinary(frame.duplicate(), Callback.NOOP);
            return;
        }
        List<String> others = texts.subList(1, texts.size());
        session.sendText(texts.get(0), Callback.from(() -> send(session, others, frame), failure -> {}));
    }

    void sayGoodbye() {
        Session session = getSession();
        if (session != null) {
            session.close(StatusCode.SHUTDOWN, "The simulator has ended.", Callback.NOOP);
        }
    }

    @Override
    public void onWebSocketClose(int statusCode, @Nullable String reason, Callback callback) {
        feed.remove(this);
        callback.succeed();
    }

    @Override
    public void onWebSocketError(Throwable cause) {
        feed.remove(this);
    }
}

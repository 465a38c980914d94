package org.robonewbie.studio;

import com.google.gson.JsonObject;
import java.nio.ByteBuffer;
import java.util.concurrent.TimeUnit;
import org.eclipse.jetty.websocket.api.Callback;
import org.eclipse.jetty.websocket.api.Session;
import org.eclipse.jetty.websocket.api.StatusCode;
import org.jspecify.annotations.Nullable;
import org.robonewbie.simulator.SimulationControl;

/**
 * One page that looks at the simulation.
 *
 * <p>It gets its next frame only after it has reported that the last one was drawn, so a page that is frozen or hidden has
 * at most one frame on its way. A frame that did not change is repeated once per second, which tells the page that the
 * studio is alive although the world stands still.
 */
public final class Spectator extends Session.Listener.AbstractAutoDemanding {

    private static final long REPEAT_NANOS = TimeUnit.SECONDS.toNanos(1);

    private final LiveFeed feed;
    private final SimulationControl simulation;
    private volatile boolean ready;
    private int sentScene = -1;
    private @Nullable ByteBuffer sentFrame;
    private long sentNanos;

    Spectator(LiveFeed feed, SimulationControl simulation) {
        this.feed = feed;
        this.simulation = simulation;
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
            StudioCommand command = StudioCommandReader.read(message);
            if (command instanceof StudioCommand.Seen) {
                ready = true;
            } else {
                command.applyTo(simulation);
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

    /**
     * Sends a frame, and before it the scene if the page does not have it yet; does nothing while the page is busy. Called
     * by the feed's thread only.
     */
    void offer(int sceneRevision, String sceneJson, ByteBuffer frame) {
        boolean repeated = frame.equals(sentFrame);
        if (!ready || (repeated && System.nanoTime() - sentNanos < REPEAT_NANOS)) {
            return;
        }
        ready = false;
        sentFrame = frame;
        sentNanos = System.nanoTime();
        Session session = getSession();
        if (sentScene == sceneRevision) {
            session.sendBinary(frame.duplicate(), Callback.NOOP);
        } else {
            sentScene = sceneRevision;
            session.sendText(
                    sceneJson,
                    Callback.from(() -> session.sendBinary(frame.duplicate(), Callback.NOOP), failure -> {}));
        }
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

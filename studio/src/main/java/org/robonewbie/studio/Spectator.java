package org.robonewbie.studio;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.nio.ByteBuffer;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.eclipse.jetty.websocket.api.Callback;
import org.eclipse.jetty.websocket.api.Session;
import org.eclipse.jetty.websocket.api.StatusCode;
import org.jspecify.annotations.Nullable;
import org.robonewbie.protocol.telemetry.TelemetryItem;
import org.robonewbie.protocol.telemetry.TelemetryLine;
import org.robonewbie.protocol.telemetry.TelemetryMessage;
import org.robonewbie.simulator.AgentMessages;
import org.robonewbie.studio.roboviz.RoboVizBoard;

/**
 * A page that watches the simulation.
 *
 * <p>It receives its next frame only after it has reported that the last one was drawn, so a page that is frozen or hidden has
 * at most one frame on its way. A frame that has not changed is repeated once per second, which shows the page that the studio
 * is alive although the world is paused.
 */
public final class Spectator extends Session.Listener.AbstractAutoDemanding {

    private static final int MOST_LINES = 2000;
    private static final int MOST_MESSAGES = 200;
    private static final int MOST_NEWS = 100;
    private static final long REPEAT_NANOS = TimeUnit.SECONDS.toNanos(1);

    private final LiveFeed feed;
    private final Deque<String> heard = new ArrayDeque<>();
    private final Map<String, TelemetryMessage> pictures = new LinkedHashMap<>();
    private final Deque<AgentMessages> talk = new ArrayDeque<>();
    private final Deque<String> news = new ArrayDeque<>();
    private volatile String watched = "";
    private volatile boolean begins;
    private long toldCycle = -1;
    private Optional<Deeds.Names> toldDeeds = Optional.empty();
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
                watched = TelemetryHistory.key(watch.team(), watch.number());
                begins = true;
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

    boolean watches(String robot) {
        return watched.equals(robot);
    }

    /** Takes the telemetry from before the page began to watch. Called by the feed's thread only. */
    void remember(TelemetryHistory memory) {
        if (begins) {
            begins = false;
            heard.clear();
            talk.clear();
            toldCycle = -1;
            memory.of(watched).forEach(this::hear);
        }
    }

    /**
     * Keeps all that the watched robot tells, and the newest picture that each other robot draws, until the page is ready for
     * it. Called by the feed's thread only.
     */
    void hear(TelemetryMessage message) {
        String robot = TelemetryHistory.key(message.team(), message.number());
        if (watches(robot)) {
            heard.add(TelemetryLine.write(message));
            if (heard.size() > MOST_LINES) {
                heard.remove();
            }
        } else if (message.item() instanceof TelemetryItem.Picture) {
            pictures.put(robot, message);
        }
    }

    /** Keeps what the watched robot's agent says and hears. Called by the feed's thread only. */
    void hear(String robot, AgentMessages messages) {
        if (watches(robot) && messages.cycle() != toldCycle) {
            toldCycle = messages.cycle();
            talk.add(messages);
            if (talk.size() > MOST_MESSAGES) {
                talk.remove();
            }
        }
    }

    /** Keeps what has happened in the game until the page is ready for it. Called by the feed's thread only. */
    void tell(String json) {
        news.add(json);
        if (news.size() > MOST_NEWS) {
            news.remove();
        }
    }

    /** Passes on what would be undone and redone, if the page does not know it yet. Called by the feed's thread only. */
    void tellDeeds(Deeds.Names names) {
        if (!toldDeeds.equals(Optional.of(names))) {
            toldDeeds = Optional.of(names);
            tell(LineUpWriter.deeds(names));
        }
    }

    /** Keeps the sets of drawings that have changed since the page has got its last frame. Called by the feed's thread only. */
    void tellDrawings(RoboVizBoard board) {
        int revision = board.revision();
        if (ready && revision > toldBoard) {
            board.since(toldBoard).ifPresent(this::tell);
            toldBoard = revision;
        }
    }

    private String thoughts() {
        JsonArray lines = new JsonArray();
        heard.forEach(lines::add);
        heard.clear();
        JsonArray drawings = new JsonArray();
        pictures.values().forEach(picture -> drawings.add(TelemetryLine.write(picture)));
        pictures.clear();
        JsonArray exchanged = new JsonArray();
        for (AgentMessages messages : talk) {
            JsonArray one = new JsonArray();
            one.add(messages.cycle());
            one.add(messages.perceptors());
            one.add(messages.effectors());
            exchanged.add(one);
        }
        talk.clear();
        JsonObject json = new JsonObject();
        json.addProperty("kind", "telemetry");
        json.addProperty("robot", watched);
        json.add("lines", lines);
        json.add("drawings", drawings);
        json.add("messages", exchanged);
        return json.toString();
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
        if (!heard.isEmpty() || !talk.isEmpty() || !pictures.isEmpty()) {
            texts.add(thoughts());
        }
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

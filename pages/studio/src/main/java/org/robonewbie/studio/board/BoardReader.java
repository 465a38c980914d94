package org.robonewbie.studio.board;

import org.eclipse.jetty.websocket.api.Callback;
import org.eclipse.jetty.websocket.api.Session;
import org.jspecify.annotations.Nullable;

/**
 * WebSocket connection of a page that subscribes to an {@link EventBus}. A page that is too slow misses updates and then receives
 * the whole state again.
 */
public final class BoardReader extends Session.Listener.AbstractAutoDemanding {

    private final EventBus board;
    private boolean busy;
    private boolean missed;

    /**
     * Creates a subscriber.
     *
     * @param board the event bus
     */
    public BoardReader(EventBus board) {
        this.board = board;
    }

    @Override
    public void onWebSocketOpen(Session session) {
        super.onWebSocketOpen(session);
        board.add(this);
    }

    @Override
    public void onWebSocketClose(int statusCode, @Nullable String reason, Callback callback) {
        board.remove(this);
        callback.succeed();
    }

    @Override
    public void onWebSocketError(Throwable cause) {
        board.remove(this);
    }

    /** Sends an update unless the previous one is still in flight. Called only by the bus, which holds its lock. */
    synchronized void offer(String json) {
        missed |= busy;
        if (!busy) {
            busy = true;
            getSession().sendText(json, Callback.from(this::sent, failure -> {}));
        }
    }

    private void sent() {
        if (becomesFree()) {
            board.resend(this);
        }
    }

    private synchronized boolean becomesFree() {
        boolean again = missed;
        busy = false;
        missed = false;
        return again;
    }
}

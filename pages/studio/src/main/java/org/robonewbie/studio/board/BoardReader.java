package org.robonewbie.studio.board;

import org.eclipse.jetty.websocket.api.Callback;
import org.eclipse.jetty.websocket.api.Session;
import org.jspecify.annotations.Nullable;

/**
 * A page that watches a {@link EventBus}. If it is slower than the program it misses something, and then receives everything
 * again.
 */
public final class BoardReader extends Session.Listener.AbstractAutoDemanding {

    private final EventBus board;
    private boolean busy;
    private boolean missed;

    /**
     * Expects a page.
     *
     * @param board what it will look at
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

    /** Sends news, unless the page is still busy. Called by the board only, which no other thread writes to meanwhile. */
    synchronized void offer(String json) {
        missed |= busy;
        if (!busy) {
            busy = true;
            getSession().sendText(json, Callback.from(this::sent, failure -> {}));
        }
    }

    private void sent() {
        if (becomesFree()) {
            board.tellAgain(this);
        }
    }

    private synchronized boolean becomesFree() {
        boolean again = missed;
        busy = false;
        missed = false;
        return again;
    }
}

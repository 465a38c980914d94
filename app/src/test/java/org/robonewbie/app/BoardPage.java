package org.robonewbie.app;

import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.robonewbie.studio.StudioCookie;
import org.robonewbie.studio.board.EventBus;

/** A page that watches a board of the studio, without a browser. */
public final class BoardPage implements WebSocket.Listener, AutoCloseable {

    private static final long PATIENCE_SECONDS = 120;

    private final BlockingQueue<String> news = new LinkedBlockingQueue<>();
    private final StringBuilder part = new StringBuilder();
    private final WebSocket socket;

    /**
     * Opens the page.
     *
     * @param page its address
     * @param board the last word of the address at which it listens
     */
    public BoardPage(URI page, String board) {
        URI feed = URI.create("ws://" + page.getAuthority() + EventBus.PATHS + board);
        this.socket = HttpClient.newHttpClient()
                .newWebSocketBuilder()
                .header("Origin", "http://" + page.getAuthority())
                .header("Cookie", StudioCookie.of(page))
                .buildAsync(feed, this)
                .join();
    }

    @Override
    public @Nullable CompletionStage<?> onText(WebSocket one, CharSequence text, boolean last) {
        part.append(text);
        if (last) {
            news.add(part.toString());
            part.setLength(0);
        }
        one.request(1);
        return null;
    }

    /** {@return the next message} */
    public String next() {
        try {
            String message = news.poll(PATIENCE_SECONDS, TimeUnit.SECONDS);
            if (message == null) {
                throw new AssertionError("The board says nothing for " + PATIENCE_SECONDS + " s.");
            }
            return message;
        } catch (InterruptedException isOver) {
            throw new AssertionError(isOver);
        }
    }

    /** Waits for a message with some words in it, and returns it. */
    public String next(String words) {
        String message = next();
        while (!message.contains(words)) {
            message = next();
        }
        return message;
    }

    @Override
    public void close() {
        socket.abort();
    }
}

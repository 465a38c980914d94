package org.robonewbie.studio;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;

/** Connection in the Chrome DevTools protocol: calls, responses and events. */
final class DevTools implements WebSocket.Listener {

    private final WebSocket socket;
    private final Consumer<JsonObject> events;
    private final AtomicInteger lastCall = new AtomicInteger();
    private final Map<Integer, CompletableFuture<JsonObject>> calls = new ConcurrentHashMap<>();
    private final StringBuilder text = new StringBuilder();

    /** Connects; events arrive on a thread of the connection, which must not block. */
    DevTools(URI address, Consumer<JsonObject> events) {
        this.events = events;
        this.socket = HttpClient.newHttpClient()
                .newWebSocketBuilder()
                .buildAsync(address, this)
                .join();
    }

    /** Calls a method of the browser, or of the page with the given session. */
    synchronized CompletableFuture<JsonObject> send(String session, String method, JsonObject parameters) {
        int id = lastCall.incrementAndGet();
        JsonObject message = new JsonObject();
        message.addProperty("id", id);
        message.addProperty("method", method);
        message.add("params", parameters);
        if (!session.isEmpty()) {
            message.addProperty("sessionId", session);
        }
        CompletableFuture<JsonObject> answer = new CompletableFuture<>();
        calls.put(id, answer);
        socket.sendText(message.toString(), true).join();
        return answer;
    }

    @Override
    public CompletionStage<?> onText(WebSocket webSocket, CharSequence data, boolean last) {
        text.append(data);
        if (last) {
            receive(JsonParser.parseString(text.toString()).getAsJsonObject());
            text.setLength(0);
        }
        webSocket.request(1);
        return CompletableFuture.completedFuture(null);
    }

    private void receive(JsonObject message) {
        CompletableFuture<JsonObject> call =
                message.has("id") ? calls.remove(message.get("id").getAsInt()) : null;
        if (call != null && message.has("result")) {
            call.complete(message.getAsJsonObject("result"));
        } else if (call != null) {
            call.completeExceptionally(new AssertionError(message.toString()));
        } else if (message.has("method")) {
            events.accept(message);
        }
    }
}

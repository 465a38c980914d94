package org.robonewbie.studio.replay;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.URLDecoder;
import java.nio.ByteBuffer;
import java.nio.channels.SeekableByteChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import java.util.zip.GZIPOutputStream;
import org.eclipse.jetty.http.HttpHeader;
import org.eclipse.jetty.server.Handler;
import org.eclipse.jetty.server.Request;
import org.eclipse.jetty.server.Response;
import org.eclipse.jetty.util.Callback;
import org.robonewbie.simulator.file.RecordingShelf;
import org.robonewbie.simulator.monitor.RecordedLog;

/**
 * Serves recordings to the pages.
 *
 * <pre>
 * GET /api/recordings                 all recordings, the newest first
 * GET /api/recordings/NAME?from=N     its bytes from the N-th on, at most four million at once
 * GET /api/cards/NAME                 its teams, score, length and events, and where everybody is at its end
 * GET /api/log/NAME                   the recording as the log of a SimSpark server, packed with gzip
 * GET /api/notes/NAME                 what robots logged and drew meanwhile, one line of JSON each
 * GET /api/models                     the bodies of all robot types
 * </pre>
 */
public final class ReplayApi extends Handler.Abstract {

    private static final String LIST = "/api/recordings";
    private static final String CARDS = "/api/cards/";
    private static final String LOG = "/api/log/";
    private static final String NOTES = "/api/notes/";
    private static final String MODELS = "/api/models";
    private static final String UNFINISHED = ".part";
    private static final int MOST_BYTES = 4_000_000;
    private static final long STILL_RUNNING_MILLIS = 4000;

    private final Optional<RecordingShelf> shelf;
    private final Optional<Path> opened;
    private final String models;
    private final RecordingCards cards = new RecordingCards();

    /**
     * Opens the room.
     *
     * @param shelf where the recordings are; empty if nothing is recorded
     * @param opened a recording that lies elsewhere
     * @param models the bodies of all robot types as JSON, by type
     */
    public ReplayApi(Optional<RecordingShelf> shelf, Optional<Path> opened, JsonObject models) {
        this.shelf = shelf;
        this.opened = opened;
        this.models = models.toString();
    }

    @Override
    public boolean handle(Request request, Response response, Callback callback) throws Exception {
        String path = Request.getPathInContext(request);
        Optional<String> kind = Stream.of(LIST, CARDS, LOG, NOTES, MODELS)
                .filter(path::startsWith)
                .findFirst();
        if (!request.getMethod().equals("GET") || kind.isEmpty()) {
            return false;
        }
        if (path.equals(MODELS) || path.equals(LIST)) {
            byte[] json = (path.equals(MODELS) ? models : list()).getBytes(StandardCharsets.UTF_8);
            send(response, callback, 200, "application/json", ByteBuffer.wrap(json));
            return true;
        }
        String name = path.substring(
                kind.get().equals(LIST) ? LIST.length() + 1 : kind.get().length());
        Optional<Path> file = find(URLDecoder.decode(name, StandardCharsets.UTF_8));
        if (file.isEmpty()) {
            byte[] text = "There is no such recording any more. Choose another one.".getBytes(StandardCharsets.UTF_8);
            send(response, callback, 404, "text/plain;charset=utf-8", ByteBuffer.wrap(text));
        } else if (kind.get().equals(CARDS)) {
            byte[] card = cards.of(file.get()).getBytes(StandardCharsets.UTF_8);
            send(response, callback, 200, "application/json", ByteBuffer.wrap(card));
        } else if (kind.get().equals(NOTES)) {
            byte[] notes = RunNotes.read(file.get()).getBytes(StandardCharsets.UTF_8);
            send(response, callback, 200, "application/x-ndjson;charset=utf-8", ByteBuffer.wrap(notes));
        } else if (kind.get().equals(LOG)) {
            send(response, callback, 200, "application/gzip", ByteBuffer.wrap(log(file.get())));
        } else {
            long from = from(request);
            send(response, callback, 200, "application/octet-stream", read(file.get(), from));
        }
        return true;
    }

    private static void send(Response response, Callback callback, int status, String type, ByteBuffer content) {
        response.setStatus(status);
        response.getHeaders().put(HttpHeader.CONTENT_TYPE, type).put(HttpHeader.CACHE_CONTROL, "no-store");
        response.write(true, content, callback);
    }

    private static byte[] log(Path recording) throws IOException {
        Path log = Files.createTempFile("robonewbie", ".log");
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (GZIPOutputStream out = new GZIPOutputStream(packed)) {
            RecordedLog.write(recording, log);
            Files.copy(log, out);
        } finally {
            Files.delete(log);
        }
        return packed.toByteArray();
    }

    private static long from(Request request) {
        try {
            String text = Request.extractQueryParameters(request).getValue("from");
            return text == null ? 0 : Math.max(0, Long.parseLong(text));
        } catch (NumberFormatException e) {
            return 0;
        }
    }

    private static ByteBuffer read(Path file, long from) throws IOException {
        try (SeekableByteChannel channel = Files.newByteChannel(file)) {
            long rest = Math.max(0, channel.size() - from);
            ByteBuffer content = ByteBuffer.allocate((int) Math.min(rest, MOST_BYTES));
            channel.position(from);
            int count = channel.read(content);
            while (count >= 0 && content.hasRemaining()) {
                count = channel.read(content);
            }
            return content.flip();
        }
    }

    /**
     * Looks up a recording.
     *
     * @param name its name in the list
     * @return its file; empty if there is none of that name
     */
    public Optional<Path> recording(String name) {
        try {
            return find(name);
        } catch (IOException unreadable) {
            return Optional.empty();
        }
    }

    /** Only what the list names can be read, so no path leads out of the folder; a run that has ended keeps its name. */
    private Optional<Path> find(String name) throws IOException {
        return files().stream().filter(file -> name(file).equals(name)).findFirst();
    }

    private List<Path> files() throws IOException {
        List<Path> files = new ArrayList<>(opened.stream().toList());
        if (shelf.isPresent()) {
            files.addAll(shelf.get().list());
        }
        return files;
    }

    static String name(Path file) {
        return String.valueOf(file.getFileName()).replace(UNFINISHED, "").replace(RecordingShelf.ENDING, "");
    }

    private String list() throws IOException {
        JsonArray recordings = new JsonArray();
        for (Path file : files()) {
            describe(file).ifPresent(recordings::add);
        }
        JsonObject json = new JsonObject();
        json.add("recordings", recordings);
        shelf.ifPresent(place -> json.addProperty("folder", place.folder().toString()));
        return json.toString();
    }

    /** Empty if the file has just gone. */
    private static Optional<JsonObject> describe(Path file) throws IOException {
        try {
            JsonObject json = new JsonObject();
            json.addProperty("name", name(file));
            json.addProperty("bytes", Files.size(file));
            json.addProperty("running", isRunning(file));
            return Optional.of(json);
        } catch (NoSuchFileException gone) {
            return Optional.empty();
        }
    }

    /** Whether a recording is still being written. */
    static boolean isRunning(Path file) {
        try {
            long age =
                    System.currentTimeMillis() - Files.getLastModifiedTime(file).toMillis();
            return file.toString().endsWith(UNFINISHED) && age < STILL_RUNNING_MILLIS;
        } catch (IOException gone) {
            return false;
        }
    }
}

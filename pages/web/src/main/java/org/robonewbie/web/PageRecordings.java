package org.robonewbie.web;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robonewbie.simulator.file.RecordingAbout;
import org.robonewbie.simulator.json.Json;
import org.robonewbie.studio.replay.RecordingEntry;
import org.robonewbie.studio.replay.RecordingStore;
import org.robonewbie.studio.replay.ReplayService;
import org.robonewbie.studio.replay.RunReading;
import org.robonewbie.studio.replay.RunWatch;

/**
 * Recordings in the page. Each request contains the metadata of the recordings stored by the browser; the bytes of a recording are passed
 * in advance. The page receives changes to the metadata as messages and stores them.
 */
final class PageRecordings implements RecordingStore {

    private static final String REMOVED_AT = "removedAt";

    private final ReplayService service = new ReplayService(this);
    private final Map<String, Reader> readers = new HashMap<>();
    private List<JsonObject> stored = List.of();

    /** Handles a request; returns JSON, or a sentence if the request is rejected. */
    String answer(ServiceRequest request) {
        stored =
                request.elements("recordings").map(JsonElement::getAsJsonObject).toList();
        return request.answer(service);
    }

    /**
     * Parses the next bytes of a recording.
     *
     * @param id its identifier
     * @param from offset of the bytes in the uncompressed recording
     * @param bytes the bytes; ignored if others must be parsed first
     * @return offset of the bytes to be passed next
     */
    int read(String id, int from, byte[] bytes) {
        Reader reader = readers.computeIfAbsent(id, each -> new Reader());
        if (from == reader.read) {
            reader.push(bytes);
        }
        return reader.read;
    }

    private static final class Reader {

        private final RunWatch watch = new RunWatch();
        private boolean isDamaged;
        private int read;

        void push(byte[] bytes) {
            read += bytes.length;
            try {
                if (!isDamaged) {
                    watch.push(bytes, bytes.length);
                }
            } catch (IllegalArgumentException endOfWhatIsGood) {
                isDamaged = true;
            }
        }
    }

    @Override
    public List<RecordingEntry> all() {
        return stored.stream()
                .filter(entry -> !isRemoved(entry))
                .map(entry -> new RecordingEntry(
                        entry.get("name").getAsString(),
                        entry.get("bytes").getAsLong(),
                        entry.get("running").getAsBoolean(),
                        true,
                        RecordingAbout.of(entry)))
                .toList();
    }

    private static boolean isRemoved(JsonObject entry) {
        return entry.get(REMOVED_AT).getAsLong() > 0;
    }

    private Optional<JsonObject> find(String name, boolean isRemoved) {
        return stored.stream()
                .filter(entry -> isRemoved(entry) == isRemoved
                        && entry.get("name").getAsString().equals(name))
                .findFirst();
    }

    @Override
    public Optional<String> folder() {
        return Optional.empty();
    }

    @Override
    public void write(String name, RecordingAbout about) {
        change(find(name, false), about.json());
    }

    @Override
    public void rename(String from, String to) {
        change(find(from, false), Json.object("name", to));
    }

    @Override
    public void remove(String name) {
        change(find(name, false), Json.object(REMOVED_AT, System.currentTimeMillis()));
    }

    @Override
    public boolean bringBack(String name) {
        return change(find(name, true), Json.object(REMOVED_AT, 0));
    }

    /** Posts a change to a recording's metadata, if the recording is stored. */
    private static boolean change(Optional<JsonObject> entry, JsonObject change) {
        entry.ifPresent(stored -> {
            change.add("id", stored.get("id"));
            PageContext.post("recording", change.toString());
        });
        return entry.isPresent();
    }

    @Override
    public RunReading read(String name, long milliseconds) {
        RunWatch watch = find(name, false)
                .map(entry -> readers.get(entry.get("id").getAsString()))
                .orElseGet(Reader::new)
                .watch;
        return new RunReading(watch.summary(), true, watch.count() == 0 ? List.of() : List.of(0));
    }
}

package org.robonewbie.studio.replay;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.util.List;
import java.util.function.UnaryOperator;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.nao.text.FileName;
import org.robonewbie.simulator.file.RecordingAbout;
import org.robonewbie.simulator.file.RecordingRepository;
import org.robonewbie.simulator.json.Json;
import org.robonewbie.studio.service.PageService;

/**
 * Lists, summarises, renames, stars, bookmarks, deletes and restores recordings. Responses are JSON.
 *
 * <pre>
 * GET    recordings               all recordings with their metadata
 * GET    cards/NAME               summary: teams, score, length, events, and the trails of the ball and the robots
 * GET    index/NAME               the summary and the first cycle of each piece; returns immediately, even if incomplete
 * GET    index/NAME?events=M&amp;pieces=N     the same without the first M events and N pieces PUT
 * recordings/NAME?was=OLD            renames the recording OLD PUT    recordings/NAME?removed=yes        restores a deleted
 * recording DELETE recordings/NAME                    deletes the recording PUT, DELETE stars/NAME                    sets
 * or removes the star, which protects the recording from automatic deletion PUT    bookmarks/NAME?seconds=T&amp;note=TEXT
 * adds a bookmark DELETE bookmarks/NAME?seconds=T           removes the bookmark
 * </pre>
 */
public final class ReplayService implements PageService {

    /** Message for a recording that was not found. */
    public static final String GONE = "This recording no longer exists. Choose another one.";

    private static final List<String> FILE_ENDINGS = List.of(RecordingRepository.ENDING, AtomicFile.UNFINISHED);
    private static final long TIME_LIMIT_MILLIS = 250;

    private final RecordingStore store;

    /**
     * Creates the service.
     *
     * @param store the recordings
     */
    public ReplayService(RecordingStore store) {
        this.store = store;
    }

    @Override
    public String answer(String method, List<String> path, UnaryOperator<String> parameters) throws IOException {
        String name = name(path);
        if (!method.equals("GET")) {
            change(path.get(0), method.equals("PUT"), name, parameters);
            return "{}";
        }
        return switch (path.get(0)) {
            case "cards" -> card(read(name, Integer.MAX_VALUE)).toString();
            case "index" -> index(read(name, TIME_LIMIT_MILLIS), parameters).toString();
            default -> list().toString();
        };
    }

    /** Returns the name of the recording in a path. */
    static String name(List<String> path) {
        return String.join("/", path.subList(1, path.size()));
    }

    private RunReading read(String name, long milliseconds) throws IOException {
        return store.read(find(name).name(), milliseconds);
    }

    private RecordingEntry find(String name) throws IOException {
        return store.all().stream()
                .filter(entry -> entry.name().equals(name))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(GONE));
    }

    private JsonObject list() throws IOException {
        JsonObject json =
                Json.object("recordings", Json.array(store.all().stream().map(ReplayService::describe)));
        store.folder().ifPresent(folder -> json.addProperty("folder", folder));
        return json;
    }

    private static JsonObject describe(RecordingEntry entry) {
        JsonObject json = entry.about().json();
        json.remove("project");
        json.addProperty("name", entry.name());
        json.addProperty("bytes", entry.bytes());
        json.addProperty("running", entry.running());
        json.addProperty("ofProject", entry.ofProject());
        return json;
    }

    private static JsonObject card(RunReading reading) {
        JsonObject card = reading.summary().deepCopy();
        card.remove("rosters");
        card.remove("header");
        return card;
    }

    private static JsonObject index(RunReading reading, UnaryOperator<String> parameters) {
        boolean isFirst = parameters.apply("events").isEmpty();
        JsonObject json = isFirst ? reading.summary().deepCopy() : new JsonObject();
        json.add("count", reading.summary().get("count"));
        json.addProperty("whole", reading.whole());
        List<JsonElement> events = reading.summary().getAsJsonArray("events").asList();
        json.add("events", Json.array(events.stream().skip(number(parameters.apply("events")))));
        json.add("pieces", Json.array(reading.pieces().stream().skip(number(parameters.apply("pieces")))));
        return json;
    }

    /**
     * Parses a count.
     *
     * @param text value of a parameter
     * @return the count; 0 if it is missing or invalid
     */
    static long number(String text) {
        try {
            return Math.max(0, Long.parseLong(text));
        } catch (NumberFormatException none) {
            return 0;
        }
    }

    private synchronized void change(String kind, boolean isPut, String name, UnaryOperator<String> parameters)
            throws IOException {
        switch (kind) {
            case "stars" -> annotate(name, about -> about.withStar(isPut));
            case "bookmarks" -> {
                double seconds = seconds(parameters.apply("seconds"));
                annotate(
                        name,
                        about -> isPut
                                ? about.withBookmark(seconds, parameters.apply("note"))
                                : about.withoutBookmark(seconds));
            }
            default -> changeFile(isPut, name, parameters);
        }
    }

    private void annotate(String name, UnaryOperator<RecordingAbout> change) throws IOException {
        store.write(name, change.apply(find(name).about()));
    }

    private static double seconds(String text) {
        try {
            double seconds = Double.parseDouble(text);
            if (seconds >= 0 && Double.isFinite(seconds)) {
                return seconds;
            }
        } catch (NumberFormatException none) {
            // The exception below reports the problem.
        }
        throw new IllegalArgumentException("The time of the bookmark is missing. Reload the page.");
    }

    private void changeFile(boolean isPut, String name, UnaryOperator<String> parameters) throws IOException {
        String old = parameters.apply("was");
        if (!isPut) {
            requireFinished(name);
            store.remove(name);
        } else if (!old.isEmpty()) {
            rename(old, name);
        } else {
            requireUnused(name);
            if (!store.bringBack(name)) {
                throw new IllegalArgumentException(
                        "The recording \"" + name + "\" cannot be restored: it was deleted more than an hour ago.");
            }
        }
    }

    private void rename(String from, String to) throws IOException {
        requireFinished(from);
        if (from.equals(to)) {
            return;
        }
        boolean looksLikeFile = FILE_ENDINGS.stream().anyMatch(to::endsWith);
        if (looksLikeFile || !FileName.isPlain(to, " _.,()+-", FileName.MAX_CHARACTERS)) {
            throw new IllegalArgumentException(
                    "A recording cannot be named \"" + to
                            + "\". Use at most 80 letters, digits, spaces and . , ( ) + - _, beginning with a letter or digit.");
        }
        requireUnused(to);
        store.rename(from, to);
    }

    private void requireFinished(String name) throws IOException {
        if (find(name).running()) {
            throw new IllegalArgumentException(
                    "\"" + name + "\" is still being recorded. Stop the run first, or reset it in the Field room.");
        }
    }

    private void requireUnused(String name) throws IOException {
        if (store.all().stream().anyMatch(entry -> entry.name().equals(name))) {
            throw new IllegalArgumentException(
                    "There is already a recording named \"" + name + "\". Choose another name.");
        }
    }
}

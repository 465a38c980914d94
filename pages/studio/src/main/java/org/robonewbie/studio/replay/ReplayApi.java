package org.robonewbie.studio.replay;

import com.google.gson.Gson;
import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.zip.GZIPOutputStream;
import org.eclipse.jetty.server.Request;
import org.eclipse.jetty.util.Fields;
import org.robonewbie.nao.file.TemporaryFiles;
import org.robonewbie.simulator.file.RecordingAbout;
import org.robonewbie.simulator.file.RecordingRepository;
import org.robonewbie.simulator.monitor.RecordedLog;
import org.robonewbie.studio.file.Answer;
import org.robonewbie.studio.file.ApiHandler;
import org.robonewbie.studio.file.PathPart;

/**
 * HTTP endpoint for recordings.
 *
 * <pre>
 * GET /api/recordings                 all recordings with their metadata, the newest first
 * GET /api/cards/NAME                 summary: teams, score, length, events, and the trails of the ball and the robots
 * GET /api/index/NAME                 the summary and the first cycle of each piece; returns immediately, even if incomplete
 * GET /api/index/NAME?events=M&amp;pieces=N    only what follows the first M events and N pieces
 * GET /api/pieces/NAME?piece=N&amp;skip=M   the N-th piece without its first M bytes
 * GET /api/log/NAME                   the recording as a log of a SimSpark server, compressed with gzip
 * GET /api/notes/NAME?skip=M          log entries and drawings as JSON lines, without the first M bytes
 * GET /api/models                     the bodies of all robot types
 * PUT /api/recordings/NAME?was=OLD    renames the recording OLD
 * PUT /api/recordings/NAME?removed=yes     restores a deleted recording
 * DELETE /api/recordings/NAME         deletes the recording
 * PUT, DELETE /api/stars/NAME         sets or removes the star, which protects the recording from automatic deletion
 * PUT /api/bookmarks/NAME?seconds=T&amp;note=TEXT    adds a bookmark
 * DELETE /api/bookmarks/NAME?seconds=T     removes the bookmark
 * </pre>
 */
public final class ReplayApi extends ApiHandler {

    private static final List<String> READ =
            List.of("recordings", "cards", "index", "pieces", "log", "notes", "models");
    private static final List<String> CHANGED = List.of("recordings", "stars", "bookmarks");
    private static final List<String> METHODS = List.of("GET", "PUT", "DELETE");
    private static final String BYTES = "application/octet-stream";
    private static final long TIME_LIMIT_MILLIS = 250;
    private static final String GONE = "This recording no longer exists. Choose another one.";

    private final RecordingPlaces places;
    private final RecordingService service;
    private final RecordingIndexes indexes = new RecordingIndexes();
    private final String models;

    /**
     * Creates the endpoint.
     *
     * @param repository automatically recorded runs; empty if nothing is recorded
     * @param projects folders of the project that may contain recordings
     * @param opened a recording in any other folder
     * @param models the bodies of all robot types as JSON, by type
     */
    public ReplayApi(
            Optional<RecordingRepository> repository, List<Path> projects, Optional<Path> opened, JsonObject models) {
        this.places = new RecordingPlaces(repository, List.copyOf(projects), opened);
        this.service = new RecordingService(places);
        this.models = models.toString();
    }

    @Override
    protected Optional<Answer> answer(Request request, String address) throws IOException {
        String[] path = address.split("/", 4);
        String method = request.getMethod();
        boolean isRead = method.equals("GET");
        if (!METHODS.contains(method)
                || path.length < 3
                || !path[1].equals("api")
                || !(isRead ? READ : CHANGED).contains(path[2])) {
            return Optional.empty();
        }
        String name = path.length < 4 ? "" : PathPart.decode(path[3]);
        Fields parameters = Request.extractQueryParameters(request);
        try {
            return Optional.of(isRead ? read(path[2], name, parameters) : change(method, path[2], name, parameters));
        } catch (NoSuchFileException gone) {
            return Optional.of(Answer.refused(404, GONE));
        }
    }

    @Override
    protected String explain(IOException problem) {
        return "The recording cannot be read or written: " + problem.getMessage()
                + ". Check that its folder is writable and that there is free disk space.";
    }

    private Answer read(String kind, String name, Fields parameters) throws IOException {
        if (kind.equals("models")) {
            return Answer.json(models);
        }
        if (kind.equals("recordings") && name.isEmpty()) {
            return Answer.json(list());
        }
        Path file = places.find(name).orElseThrow(() -> new NoSuchFileException(name));
        return switch (kind) {
            case "cards" -> Answer.json(card(file));
            case "index" -> Answer.json(index(file, parameters));
            case "pieces" ->
                Answer.of(
                        BYTES,
                        indexes.of(file).piece(file, (int) number(parameters, "piece"), number(parameters, "skip")));
            case "log" -> Answer.of("application/gzip", log(file));
            case "notes" ->
                Answer.of("application/x-ndjson;charset=utf-8", RunNotes.read(file, number(parameters, "skip")));
            default -> Answer.refused(404, GONE);
        };
    }

    private Answer change(String method, String kind, String name, Fields parameters) throws IOException {
        boolean isPut = method.equals("PUT");
        switch (kind) {
            case "stars" -> service.note(name, about -> about.withStar(isPut));
            case "bookmarks" -> {
                double seconds = seconds(parameters);
                String note = Optional.ofNullable(parameters.getValue("note")).orElse("");
                service.note(name, about -> mark(about, isPut, seconds, note));
            }
            default -> changeFile(isPut, name, parameters);
        }
        return Answer.json("{}");
    }

    private static RecordingAbout mark(RecordingAbout about, boolean isPut, double seconds, String note) {
        return isPut ? about.withBookmark(seconds, note) : about.withoutBookmark(seconds);
    }

    private void changeFile(boolean isPut, String name, Fields parameters) throws IOException {
        String old = parameters.getValue("was");
        if (!isPut) {
            service.remove(name);
        } else if (old == null) {
            service.bringBack(name);
        } else {
            service.rename(old, name);
        }
    }

    private String card(Path file) throws IOException {
        RecordingIndex index = indexes.of(file);
        index.readOn(file, Integer.MAX_VALUE);
        return index.summary().card();
    }

    private String index(Path file, Fields parameters) throws IOException {
        RecordingIndex index = indexes.of(file);
        index.readOn(file, TIME_LIMIT_MILLIS);
        boolean isFirst = parameters.getValue("events") == null;
        RunSummary known = index.summary();
        JsonObject json = isFirst ? new Gson().toJsonTree(known).getAsJsonObject() : new JsonObject();
        json.addProperty("count", known.count());
        json.addProperty("whole", index.isWhole());
        List<RunSummary.Event> events = known.events();
        int eventsKnown = (int) Math.min(events.size(), number(parameters, "events"));
        json.add("events", new Gson().toJsonTree(events.subList(eventsKnown, events.size())));
        int[] pieces = index.firstMoments();
        int piecesKnown = (int) Math.min(pieces.length, number(parameters, "pieces"));
        json.add(
                "pieces",
                new Gson().toJsonTree(IntStream.of(pieces).skip(piecesKnown).toArray()));
        return json.toString();
    }

    private static byte[] log(Path recording) throws IOException {
        Path log = TemporaryFiles.file("robonewbie", ".log");
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (GZIPOutputStream out = new GZIPOutputStream(packed)) {
            RecordedLog.write(recording, log);
            Files.copy(log, out);
        } finally {
            Files.delete(log);
        }
        return packed.toByteArray();
    }

    private static long number(Fields parameters, String name) {
        try {
            return Math.max(0, Long.parseLong(String.valueOf(parameters.getValue(name))));
        } catch (NumberFormatException none) {
            return 0;
        }
    }

    private static double seconds(Fields parameters) {
        try {
            double seconds = Double.parseDouble(String.valueOf(parameters.getValue("seconds")));
            if (seconds >= 0 && Double.isFinite(seconds)) {
                return seconds;
            }
        } catch (NumberFormatException none) {
            // Refused below.
        }
        throw new IllegalArgumentException("The time of the bookmark is missing. Reload the page.");
    }

    /**
     * Finds a recording.
     *
     * @param name its name in the list
     * @return its file; empty if there is none
     */
    public Optional<Path> recording(String name) {
        try {
            return places.find(name);
        } catch (IOException unreadable) {
            return Optional.empty();
        }
    }

    private String list() throws IOException {
        JsonArray recordings = new JsonArray();
        for (Map.Entry<String, Path> entry : places.all().entrySet()) {
            describe(entry.getKey(), entry.getValue()).ifPresent(recordings::add);
        }
        JsonObject json = new JsonObject();
        json.add("recordings", recordings);
        places.repository()
                .ifPresent(place -> json.addProperty("folder", place.folder().toString()));
        return json.toString();
    }

    /** Returns a description of a recording; empty if the file has just been deleted. */
    private Optional<JsonObject> describe(String name, Path file) throws IOException {
        try {
            RecordingAbout about = RecordingAbout.of(file);
            JsonObject json = new JsonObject();
            json.addProperty("name", name);
            json.addProperty("bytes", Files.size(file));
            json.addProperty("running", RecordingPlaces.isRunning(file));
            json.addProperty("agent", about.agent());
            json.addProperty("ofProject", places.isOfProject(file, about.project()));
            json.addProperty("starred", about.starred());
            json.add("bookmarks", new Gson().toJsonTree(about.bookmarks()));
            return Optional.of(json);
        } catch (NoSuchFileException gone) {
            return Optional.empty();
        }
    }
}

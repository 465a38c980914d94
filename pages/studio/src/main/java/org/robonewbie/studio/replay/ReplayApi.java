package org.robonewbie.studio.replay;

import com.google.gson.JsonObject;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.zip.GZIPOutputStream;
import org.eclipse.jetty.server.Request;
import org.robonewbie.nao.file.TemporaryFiles;
import org.robonewbie.simulator.file.RecordingRepository;
import org.robonewbie.simulator.monitor.RecordedLog;
import org.robonewbie.studio.file.Answer;
import org.robonewbie.studio.file.ApiHandler;
import org.robonewbie.studio.file.PathPart;

/**
 * HTTP endpoint for recordings.
 *
 * <pre>
 * GET /api/pieces/NAME?piece=N&amp;skip=M   the N-th piece without its first M bytes
 * GET /api/log/NAME                   the recording as a SimSpark server log, compressed with gzip GET
 * /api/notes/NAME?skip=M          log entries and drawings as JSON lines, without the first M bytes GET /api/models
 * the bodies of all robot types /api/...                            see {@link ReplayService}
 * </pre>
 */
public final class ReplayApi extends ApiHandler {

    private static final List<String> READ =
            List.of("recordings", "cards", "index", "pieces", "log", "notes", "models");
    private static final List<String> CHANGED = List.of("recordings", "stars", "bookmarks");
    private static final List<String> METHODS = List.of("GET", "PUT", "DELETE");
    private static final String API = "/api/";
    private static final String BYTES = "application/octet-stream";

    private final RecordingFolders folders;
    private final ReplayService service;
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
        this.folders = new RecordingFolders(repository, projects, opened);
        this.service = new ReplayService(folders);
        this.models = models.toString();
    }

    @Override
    protected Optional<Answer> answer(Request request, String address) throws IOException {
        String method = request.getMethod();
        List<String> path = address.startsWith(API) ? PathPart.decodeAll(address.substring(API.length())) : List.of();
        boolean isRead = method.equals("GET");
        if (!METHODS.contains(method) || path.isEmpty() || !(isRead ? READ : CHANGED).contains(path.get(0))) {
            return Optional.empty();
        }
        try {
            return Optional.of(isRead ? read(request, path) : reply(request, path));
        } catch (NoSuchFileException gone) {
            return Optional.of(Answer.refused(404, ReplayService.GONE));
        }
    }

    private Answer reply(Request request, List<String> path) throws IOException {
        return Answer.json(service.answer(request.getMethod(), path, name -> parameter(request, name)));
    }

    @Override
    protected String explain(IOException problem) {
        return "The recording cannot be read or written: " + problem.getMessage()
                + ". Check that its folder is writable and that there is free disk space.";
    }

    private Answer read(Request request, List<String> path) throws IOException {
        String kind = path.get(0);
        if (kind.equals("models")) {
            return Answer.json(models);
        }
        if (kind.equals("recordings")) {
            return reply(request, path);
        }
        Path file = folders.file(ReplayService.name(path));
        long skip = ReplayService.number(parameter(request, "skip"));
        return switch (kind) {
            case "pieces" -> {
                int piece = (int) ReplayService.number(parameter(request, "piece"));
                yield Answer.of(BYTES, folders.index(file).piece(file, piece, skip));
            }
            case "log" -> Answer.of("application/gzip", log(file));
            case "notes" -> Answer.of("application/x-ndjson;charset=utf-8", RunNotes.read(file, skip));
            default -> reply(request, path);
        };
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

    /**
     * Finds a recording.
     *
     * @param name its name in the list
     * @return its file; empty if there is none
     */
    public Optional<Path> recording(String name) {
        try {
            return Optional.of(folders.file(name));
        } catch (IOException unreadable) {
            return Optional.empty();
        }
    }
}

package org.robonewbie.studio.replay;

import com.google.gson.JsonObject;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.zip.GZIPOutputStream;
import org.eclipse.jetty.server.Request;
import org.robonewbie.nao.file.TemporaryFiles;
import org.robonewbie.simulator.file.RecordingRepository;
import org.robonewbie.simulator.monitor.RecordedLog;
import org.robonewbie.studio.file.Answer;
import org.robonewbie.studio.file.ApiHandler;
import org.robonewbie.studio.service.PageRequest;

/** HTTP endpoint for recordings. */
public final class ReplayApi extends ApiHandler {

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
        super(EnumSet.range(PageRequest.RECORDINGS, PageRequest.REMOVE_BOOKMARK));
        this.folders = new RecordingFolders(repository, projects, opened);
        this.service = new ReplayService(folders);
        this.models = models.toString();
    }

    @Override
    protected Answer answer(PageRequest asked, List<String> path, Request request) throws IOException {
        try {
            return reply(asked, path, request);
        } catch (NoSuchFileException gone) {
            return Answer.refused(404, ReplayService.GONE);
        }
    }

    private Answer reply(PageRequest asked, List<String> path, Request request) throws IOException {
        return switch (asked) {
            case MODELS -> Answer.json(models);
            case PIECE -> {
                Path file = file(path);
                int piece = (int) ReplayService.number(parameter(request, "piece"));
                yield Answer.of(BYTES, folders.index(file).piece(file, piece, skip(request)));
            }
            case LOG -> Answer.of("application/gzip", log(file(path)));
            case NOTES -> Answer.of("application/x-ndjson;charset=utf-8", RunNotes.read(file(path), skip(request)));
            default -> Answer.json(service.answer(request.getMethod(), path, name -> parameter(request, name)));
        };
    }

    private Path file(List<String> path) throws IOException {
        return folders.file(ReplayService.name(path));
    }

    private static long skip(Request request) {
        return ReplayService.number(parameter(request, "skip"));
    }

    @Override
    protected String explain(IOException problem) {
        return explain("The recording", "its folder", problem);
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

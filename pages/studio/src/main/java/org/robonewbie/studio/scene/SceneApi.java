package org.robonewbie.studio.scene;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import org.eclipse.jetty.server.Request;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.simulator.file.RecordingFile;
import org.robonewbie.simulator.recording.RecordingReader;
import org.robonewbie.studio.file.Answer;
import org.robonewbie.studio.file.ApiHandler;
import org.robonewbie.studio.file.PathPart;

/**
 * HTTP endpoint for scenes: saves them, and continues from them or from any cycle of a recording.
 *
 * <pre>
 * /api/scenes                           see {@link SceneService}; the header Replace: yes corresponds to its parameter POST
 * /api/start/RECORDING?moment=N    continues from the N-th cycle of a recording
 * </pre>
 *
 * <p>The last request returns whether the state is exact and how many agents have restored their own states.
 */
public final class SceneApi extends ApiHandler {

    private static final String SCENES = "/api/scenes";
    private static final String START = "/api/start/";

    private final Path folder;
    private final SceneService service;
    private final Function<String, Optional<Path>> recordings;

    /**
     * Creates the endpoint.
     *
     * @param folder folder of the saved scenes; it need not exist
     * @param world the running simulation
     * @param done receives file changes for the undo stack
     * @param recordings finds recordings by name
     */
    public SceneApi(
            Path folder,
            RestorableSimulation world,
            Consumer<UndoableCommand> done,
            Function<String, Optional<Path>> recordings) {
        this.folder = folder;
        this.service = new SceneService(
                new SceneFolder(folder), folder.toAbsolutePath().toString(), world, done);
        this.recordings = recordings;
    }

    @Override
    protected Optional<Answer> answer(Request request, String path) throws IOException {
        return path.startsWith(SCENES) || path.startsWith(START)
                ? Optional.of(Answer.json(reply(request, path)))
                : Optional.empty();
    }

    @Override
    protected String explain(IOException problem) {
        return explain("The scene", folder, problem);
    }

    private String reply(Request request, String path) throws IOException {
        if (path.startsWith(START) && request.getMethod().equals("POST")) {
            return start(PathPart.decode(path.substring(START.length())), moment(request));
        }
        return service.answer(
                request.getMethod(),
                PathPart.decodeAll(path.substring(SCENES.length())),
                name -> name.equals("replace") ? header(request, "Replace") : parameter(request, name));
    }

    private String start(String name, long moment) throws IOException {
        Path file = recordings
                .apply(name)
                .orElseThrow(
                        () -> new IllegalArgumentException("This recording no longer exists. Choose another one."));
        String why = file.toString().endsWith(AtomicFile.UNFINISHED)
                ? " on disk yet. Try again in a second."
                : SceneService.ENDS_BEFORE;
        try (RecordingReader recording = RecordingFile.read(file)) {
            return service.start(recording, moment, why);
        }
    }

    private static long moment(Request request) {
        try {
            return Long.parseLong(parameter(request, "moment"));
        } catch (NumberFormatException noNumber) {
            throw new IllegalArgumentException("The cycle to start from is missing. Reload the page.", noNumber);
        }
    }
}

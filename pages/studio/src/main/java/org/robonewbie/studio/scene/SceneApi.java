package org.robonewbie.studio.scene;

import java.io.IOException;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import org.eclipse.jetty.server.Request;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.simulator.file.RecordingFile;
import org.robonewbie.simulator.recording.RecordingReader;
import org.robonewbie.studio.file.Answer;
import org.robonewbie.studio.file.ApiHandler;
import org.robonewbie.studio.service.PageRequest;

/**
 * HTTP endpoint for scenes: saves them, and continues from them or from any cycle of a recording. The header {@code Replace: yes}
 * corresponds to the parameter of {@link SceneService}. A start from a recording returns whether the state is exact and how many agents have
 * restored their own states.
 */
public final class SceneApi extends ApiHandler {

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
        super(EnumSet.range(PageRequest.SCENES, PageRequest.START_FROM));
        this.folder = folder;
        this.service = new SceneService(
                new SceneFolder(folder), folder.toAbsolutePath().toString(), world, done);
        this.recordings = recordings;
    }

    @Override
    protected Answer answer(PageRequest asked, List<String> path, Request request) throws IOException {
        return Answer.json(
                asked == PageRequest.START_FROM
                        ? start(path.get(1), moment(request))
                        : service.answer(
                                request.getMethod(),
                                path.subList(1, path.size()),
                                name -> name.equals("replace")
                                        ? header(request, "Replace")
                                        : parameter(request, name)));
    }

    @Override
    protected String explain(IOException problem) {
        return explain("The scene", "the folder " + folder, problem);
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

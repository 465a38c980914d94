package org.robonewbie.studio;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Optional;
import org.robonewbie.simulator.recording.RecordingReader;
import org.robonewbie.studio.file.RefusedException;
import org.robonewbie.studio.scene.SceneRepository;
import org.robonewbie.studio.scene.SceneService;

/** Saved scenes of a page that runs the world in its own worker. */
public final class PageScenes {

    private static final String PLACE = "this browser";

    private final SceneRepository repository;

    /**
     * Creates an empty repository.
     *
     * @param keeper the persistent store in the browser
     */
    public PageScenes(SceneRepository.Keeper keeper) {
        repository = new SceneRepository(keeper);
    }

    /** {@return the scenes in memory} */
    public SceneRepository repository() {
        return repository;
    }

    /**
     * Answers a request from the page.
     *
     * @param feed the feed of the displayed world
     * @param method PUT saves or renames, DELETE removes, POST restores, any other method lists the scenes
     * @param name the scene
     * @param old previous name of a scene that is being renamed; otherwise empty
     * @return one JSON object
     * @throws RefusedException if the request is refused; the message gives the reason
     */
    public String answer(PageFeed feed, String method, String name, String old) {
        return attempt(
                feed,
                service -> service.answer(method, name, old.isEmpty() ? Optional.empty() : Optional.of(old), false));
    }

    /**
     * Continues the simulation from a cycle of a recording.
     *
     * @param feed the feed of the displayed world
     * @param recording the uncompressed bytes of the recording
     * @param moment zero-based index of the cycle
     * @return what was restored, as one JSON object
     * @throws RefusedException if the request is refused; the message gives the reason
     */
    public String start(PageFeed feed, byte[] recording, long moment) {
        return attempt(
                feed,
                service -> service.start(
                        RecordingReader.ofUnpacked(new ByteArrayInputStream(recording), "This"),
                        moment,
                        SceneService.ENDS_BEFORE));
    }

    private interface Request {
        String answer(SceneService service) throws IOException;
    }

    private String attempt(PageFeed feed, Request request) {
        UndoManager undoManager = feed.context().undoManager();
        try {
            return request.answer(new SceneService(repository, PLACE, undoManager, undoManager::done));
        } catch (IllegalArgumentException | IllegalStateException | IOException refused) {
            throw new RefusedException(409, String.valueOf(refused.getMessage()));
        }
    }
}

package org.robonewbie.studio;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Optional;
import org.robonewbie.simulator.recording.RecordingReader;
import org.robonewbie.studio.file.RefusedException;
import org.robonewbie.studio.scene.SceneRepository;
import org.robonewbie.studio.scene.SceneService;

/** The scenes of a page in whose worker the world runs. */
public final class PageScenes {

    private static final String PLACE = "this browser";

    private final SceneRepository repository;

    /**
     * Opens an empty shelf.
     *
     * @param keeper the browser, which keeps scenes for longer
     */
    public PageScenes(SceneRepository.Keeper keeper) {
        repository = new SceneRepository(keeper);
    }

    /** {@return the scenes, which the browser hands over} */
    public SceneRepository repository() {
        return repository;
    }

    /**
     * Answers a request of the page.
     *
     * @param feed shows the world
     * @param method PUT saves or renames, DELETE removes, POST goes back to a scene, all others list them
     * @param name the scene
     * @param old the scene that is renamed; empty if none is
     * @return one JSON object
     * @throws RefusedException if that cannot be; the message says why
     */
    public String answer(PageFeed feed, String method, String name, String old) {
        return attempt(
                feed,
                service -> service.answer(method, name, old.isEmpty() ? Optional.empty() : Optional.of(old), false));
    }

    /**
     * Goes on from a moment of a recording.
     *
     * @param feed shows the world
     * @param recording the bytes of the recording, not compressed
     * @param moment number of the moment, from 0
     * @return how much of it is back, as one JSON object
     * @throws RefusedException if that cannot be; the message says why
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

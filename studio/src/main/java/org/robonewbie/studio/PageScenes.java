package org.robonewbie.studio;

import java.io.IOException;
import java.util.Optional;
import org.robonewbie.studio.file.RefusedException;
import org.robonewbie.studio.scene.SceneDesk;
import org.robonewbie.studio.scene.SceneShelf;

/** The scenes of a page in whose worker the world runs. */
public final class PageScenes {

    private static final String PLACE = "this browser";

    private final SceneShelf shelf;

    /**
     * Opens an empty shelf.
     *
     * @param keeper the browser, which keeps scenes for longer
     */
    public PageScenes(SceneShelf.Keeper keeper) {
        shelf = new SceneShelf(keeper);
    }

    /** {@return the scenes, which the browser hands over} */
    public SceneShelf shelf() {
        return shelf;
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
        Deeds deeds = feed.stage().deeds();
        try {
            return new SceneDesk(shelf, PLACE, deeds, deeds::done)
                    .answer(method, name, old.isEmpty() ? Optional.empty() : Optional.of(old), false);
        } catch (IllegalArgumentException | IllegalStateException | IOException refused) {
            throw new RefusedException(409, String.valueOf(refused.getMessage()));
        }
    }
}

package org.robonewbie.studio.scene;

import java.io.IOException;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import org.robonewbie.nao.text.FileName;
import org.robonewbie.simulator.json.Json;
import org.robonewbie.simulator.recording.RecordingReader;
import org.robonewbie.studio.service.PageService;

/**
 * Saves and restores scenes. Responses are JSON.
 *
 * <pre>
 * GET                        names of all scenes
 * PUT    NAME                saves the current state; parameter replace=yes overwrites an existing scene
 * PUT    NAME?was=OLD        renames the scene OLD
 * DELETE NAME                deletes the scene; can be undone
 * POST   NAME                restores the scene
 * </pre>
 */
public final class SceneService implements PageService {

    /** End of the error message for a finished recording that does not contain the requested cycle. */
    public static final String ENDS_BEFORE = ": it ends earlier, or is damaged at that point. Choose an earlier cycle.";

    private static final int MAX_NAME_CHARACTERS = 60;
    private static final String DONE = "{}";

    private final SceneStore store;
    private final String place;
    private final RestorableSimulation world;
    private final Consumer<UndoableCommand> done;

    /**
     * Creates the service.
     *
     * @param store the saved scenes
     * @param place location of the store, shown to the user
     * @param world the running simulation
     * @param done receives scene changes for the undo stack
     */
    public SceneService(SceneStore store, String place, RestorableSimulation world, Consumer<UndoableCommand> done) {
        this.store = store;
        this.place = place;
        this.world = world;
        this.done = done;
    }

    /**
     * {@inheritDoc}
     *
     * @throws IllegalStateException if the scene cannot be restored; the message gives the reason
     */
    @Override
    public String answer(String method, List<String> path, UnaryOperator<String> parameters) throws IOException {
        String name = path.isEmpty() ? "" : path.get(0);
        switch (method) {
            case "PUT" -> put(name, parameters.apply("was"), parameters.apply("replace"));
            case "DELETE" -> delete(name);
            case "POST" -> {
                return written(world.restore(read(name).checkpoint().orElseThrow(() -> damaged(name))));
            }
            default -> {
                return list();
            }
        }
        return DONE;
    }

    private void put(String name, String old, String replace) throws IOException {
        if (!isName(name)) {
            throw new IllegalArgumentException("A scene cannot be named \"" + name
                    + "\". Use letters, digits, spaces, dots, - and _, beginning with a letter or digit.");
        }
        if (!old.isEmpty()) {
            rename(old, name);
            done.accept(new SceneCommand(
                    "scene \"" + old + "\" renamed to \"" + name + "\"",
                    () -> rename(name, old),
                    () -> rename(old, name)));
            return;
        }
        if (!replace.equals("yes")) {
            requireUnused(name);
        }
        store.write(name, SavedScene.of(world.field(), world.now(), world.save()));
    }

    private void rename(String from, String to) throws IOException {
        SavedScene scene = read(from);
        create(to, scene);
        store.delete(from);
    }

    private void delete(String name) throws IOException {
        SavedScene scene = read(name);
        store.delete(name);
        done.accept(new SceneCommand(
                "scene \"" + name + "\" deleted", () -> create(name, scene), () -> store.delete(name)));
    }

    private void create(String name, SavedScene scene) throws IOException {
        requireUnused(name);
        store.write(name, scene);
    }

    private SavedScene read(String name) throws IOException {
        if (!store.names().contains(name)) {
            throw new IllegalArgumentException("The scene \"" + name + "\" no longer exists. Reload the page.");
        }
        return store.read(name);
    }

    /** Refuses existing names, and names that differ from them only in case, because some file systems ignore case. */
    private void requireUnused(String name) throws IOException {
        if (store.names().stream().anyMatch(name::equalsIgnoreCase)) {
            throw new IllegalArgumentException("There is already a scene named \"" + name + "\". Choose another name.");
        }
    }

    private static IllegalArgumentException damaged(String name) {
        return new IllegalArgumentException("The scene \"" + name + "\" is damaged.");
    }

    /** Returns whether a name is valid for a scene. */
    static boolean isName(String name) {
        return FileName.isPlain(name, " _.-", MAX_NAME_CHARACTERS);
    }

    /**
     * Continues the simulation from a cycle of a recording.
     *
     * @param recording the recording, positioned before its first cycle
     * @param moment zero-based index of the cycle
     * @param why end of the error message if there is no such cycle
     * @return what was restored, as one JSON object
     * @throws IOException if the recording cannot be read
     * @throws IllegalArgumentException if there is no such cycle
     * @throws IllegalStateException if the state cannot be restored; the message gives the reason
     */
    public String start(RecordingReader recording, long moment, String why) throws IOException {
        return written(world.restore(SavedScene.moment(recording, moment)
                .orElseThrow(() -> new IllegalArgumentException("The recording has no cycle " + moment + why))));
    }

    private static String written(RestorableSimulation.Restored restored) {
        return Json.object("exact", restored.exact(), "agents", restored.agents())
                .toString();
    }

    private String list() throws IOException {
        return Json.object("scenes", store.names(), "folder", place).toString();
    }
}

package org.robonewbie.studio.scene;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.util.Optional;
import java.util.function.Consumer;
import org.robonewbie.simulator.recording.RecordingReader;

/** Saves and restores scenes. Answers are JSON objects for the page. */
public final class SceneService {

    /** End of the error message for a finished recording that does not contain the requested cycle. */
    public static final String ENDS_BEFORE = ": it ends earlier, or is damaged at that point. Choose an earlier cycle.";

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
     * Handles a request.
     *
     * @param method PUT saves or renames, DELETE deletes, POST restores, any other method lists the scenes
     * @param name the scene
     * @param old previous name of a scene that is being renamed; otherwise empty
     * @param replace whether saving overwrites an existing scene
     * @return the answer
     * @throws IOException if a scene cannot be read or written
     * @throws IllegalArgumentException if the request is refused; the message gives the reason
     * @throws IllegalStateException if the scene cannot be restored; the message gives the reason
     */
    public String answer(String method, String name, Optional<String> old, boolean replace) throws IOException {
        switch (method) {
            case "PUT" -> put(name, old, replace);
            case "DELETE" -> done.accept(SceneCommand.removed(store, name));
            case "POST" -> {
                return written(world.restore(store.load(name)));
            }
            default -> {
                return list();
            }
        }
        return DONE;
    }

    private void put(String name, Optional<String> old, boolean replace) throws IOException {
        if (old.isPresent()) {
            store.rename(old.get(), name);
            done.accept(SceneCommand.renamed(store, old.get(), name));
        } else {
            store.save(name, world.field(), new Checkpoint(world.now(), world.now(), world.save()), replace);
        }
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
        return written(world.restore(SceneRecording.moment(recording, moment)
                .orElseThrow(() -> new IllegalArgumentException("The recording has no cycle " + moment + why))));
    }

    private static String written(RestorableSimulation.Restored restored) {
        JsonObject json = new JsonObject();
        json.addProperty("exact", restored.exact());
        json.addProperty("agents", restored.agents());
        return json.toString();
    }

    private String list() throws IOException {
        JsonArray names = new JsonArray();
        store.names().forEach(names::add);
        JsonObject json = new JsonObject();
        json.add("scenes", names);
        json.addProperty("folder", place);
        return json.toString();
    }
}

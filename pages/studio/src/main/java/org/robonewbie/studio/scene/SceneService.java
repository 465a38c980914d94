package org.robonewbie.studio.scene;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.util.Optional;
import java.util.function.Consumer;
import org.robonewbie.simulator.recording.RecordingReader;

/** Saves scenes, and lets the world go on from them. The answers are JSON objects for the page. */
public final class SceneService {

    /** Why a whole recording may lack a moment. */
    public static final String ENDS_BEFORE = ": it ends before, or is damaged there. Choose an earlier one.";

    private static final String DONE = "{}";

    private final SceneStore store;
    private final String place;
    private final RestorableSimulation world;
    private final Consumer<UndoableCommand> done;

    /**
     * Opens the desk.
     *
     * @param store where scenes are kept
     * @param place how to call that place
     * @param world the running simulation
     * @param done takes what was done to the scenes, so that it can be undone
     */
    public SceneService(SceneStore store, String place, RestorableSimulation world, Consumer<UndoableCommand> done) {
        this.store = store;
        this.place = place;
        this.world = world;
        this.done = done;
    }

    /**
     * Answers a request.
     *
     * @param method PUT saves or renames, DELETE removes, POST goes back to a scene, all others list them
     * @param name the scene
     * @param old the scene that is renamed; empty if none is
     * @param replace whether saving overwrites an older scene
     * @return the answer
     * @throws IOException if a scene cannot be read or written
     * @throws IllegalArgumentException if that cannot be; the message says why
     * @throws IllegalStateException if the world cannot be put into the state of the scene; the message says why
     */
    public String answer(String method, String name, Optional<String> old, boolean replace) throws IOException {
        switch (method) {
            case "PUT" -> put(name, old, replace);
            case "DELETE" -> done.accept(SceneCommand.removed(store, name));
            case "POST" -> {
                return written(world.goOnFrom(store.load(name)));
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
     * Goes on from a moment of a recording.
     *
     * @param recording the recording, before its first cycle
     * @param moment number of the moment, from 0
     * @param why what to say of a recording that has no such moment
     * @return how much of it is back, as one JSON object
     * @throws IOException if the recording cannot be read
     * @throws IllegalArgumentException if it has no such moment
     * @throws IllegalStateException if the world cannot be put into that state; the message says why
     */
    public String start(RecordingReader recording, long moment, String why) throws IOException {
        return written(world.goOnFrom(SceneRecording.moment(recording, moment)
                .orElseThrow(() -> new IllegalArgumentException("The recording has no moment " + moment + why))));
    }

    /**
     * Writes how much of a kept moment is back.
     *
     * @param restored how much
     * @return one JSON object
     */
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

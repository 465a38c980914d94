package org.robonewbie.studio.scene;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.simulator.recording.RecordingReader;
import org.robonewbie.simulator.state.WorldState;

/**
 * In-memory store of scenes with a persistent backing store, such as the browser's storage. A scene consists of a recording
 * and the exact state, both as bytes.
 */
public final class SceneRepository implements SceneStore {

    private final TreeMap<String, byte[]> scenes = new TreeMap<>();
    private final Keeper keeper;

    /** The persistent backing store. */
    public interface Keeper {

        /**
         * Saves or replaces a scene.
         *
         * @param name its name
         * @param scene its bytes
         */
        void keep(String name, byte[] scene);

        /**
         * Deletes a scene.
         *
         * @param name its name
         */
        void forget(String name);
    }

    /**
     * Creates an empty repository.
     *
     * @param keeper the persistent backing store
     */
    public SceneRepository(Keeper keeper) {
        this.keeper = keeper;
    }

    /** Removes all scenes from memory. */
    public void clear() {
        scenes.clear();
    }

    /**
     * Loads a scene from the backing store into memory.
     *
     * @param name name of a scene
     * @param scene its bytes
     */
    public void take(String name, byte[] scene) {
        scenes.put(name, scene);
    }

    @Override
    public List<String> names() {
        return List.copyOf(scenes.keySet());
    }

    @Override
    public void save(String name, SoccerField field, Checkpoint moment, boolean replace) {
        if (!replace) {
            requireUnused(name);
        }
        byte[] shown = SceneRecording.toBytes(field, moment.state());
        StateWriter out = new StateWriter();
        out.putBytes(shown, shown.length);
        byte[] exact = moment.exact().map(WorldState::toBytes).orElse(new byte[0]);
        out.putBytes(exact, exact.length);
        put(name, out.toBytes());
    }

    @Override
    public Checkpoint load(String name) throws IOException {
        try {
            StateReader in = new StateReader(find(name));
            byte[] shown = in.getBytes();
            byte[] exact = in.getBytes();
            Checkpoint moment = SceneRecording.moment(
                            RecordingReader.ofUnpacked(new ByteArrayInputStream(shown), "\"" + name + "\""), 0)
                    .orElseThrow(() -> SceneStore.damaged(name));
            return new Checkpoint(moment.before(), moment.state(), state(exact));
        } catch (IllegalArgumentException | IOException damaged) {
            throw scenes.containsKey(name) ? SceneStore.damaged(name) : SceneStore.gone(name);
        }
    }

    /**
     * Returns the exact state. If it is missing or has a different version, the scene can still be restored approximately.
     */
    private static Optional<WorldState> state(byte[] exact) {
        try {
            return exact.length == 0 ? Optional.empty() : Optional.of(WorldState.ofBytes(exact));
        } catch (IllegalArgumentException ofAnotherVersion) {
            return Optional.empty();
        }
    }

    @Override
    public void rename(String from, String to) {
        requireUnused(to);
        byte[] scene = find(from);
        forget(from);
        put(to, scene);
    }

    @Override
    public Removed remove(String name) {
        byte[] scene = find(name);
        forget(name);
        return () -> {
            requireUnused(name);
            put(name, scene);
        };
    }

    private byte[] find(String name) {
        byte @Nullable [] scene = scenes.get(name);
        if (scene == null) {
            throw SceneStore.gone(name);
        }
        return scene;
    }

    private void requireUnused(String name) {
        if (scenes.containsKey(name)) {
            throw SceneStore.taken(name);
        }
    }

    private void put(String name, byte[] scene) {
        scenes.put(name, scene);
        keeper.keep(name, scene);
    }

    private void forget(String name) {
        scenes.remove(name);
        keeper.forget(name);
    }
}

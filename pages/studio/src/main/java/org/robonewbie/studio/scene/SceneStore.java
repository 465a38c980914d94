package org.robonewbie.studio.scene;

import java.io.IOException;
import java.util.List;

/** Storage of named scenes. */
public interface SceneStore {

    /**
     * Lists the scenes.
     *
     * @return their names, sorted
     * @throws IOException if they cannot be read
     */
    List<String> names() throws IOException;

    /**
     * Reads a scene.
     *
     * @param name name of a stored scene
     * @return the scene, which may be damaged
     * @throws IOException if it cannot be read
     */
    SavedScene read(String name) throws IOException;

    /**
     * Stores or replaces a scene.
     *
     * @param name its name
     * @param scene the scene
     * @throws IOException if it cannot be written
     * @throws IllegalArgumentException if a file other than a scene has this name
     */
    void write(String name, SavedScene scene) throws IOException;

    /**
     * Deletes a scene.
     *
     * @param name its name
     * @throws IOException if it cannot be deleted
     */
    void delete(String name) throws IOException;
}

package org.robonewbie.studio.scene;

import java.io.IOException;
import java.util.List;
import org.robonewbie.nao.SoccerField;

/** Store of named scenes. */
public interface SceneStore {

    /** Handle of a deleted scene. */
    interface Removed {

        /**
         * Restores the scene.
         *
         * @throws IOException if it cannot be written
         * @throws IllegalArgumentException if its name is in use again
         */
        void bringBack() throws IOException;
    }

    /**
     * Lists the scenes.
     *
     * @return their names, sorted
     * @throws IOException if they cannot be read
     */
    List<String> names() throws IOException;

    /**
     * Saves a scene.
     *
     * @param name its name
     * @param field the pitch
     * @param moment the checkpoint to save
     * @param replace whether an existing scene of this name is overwritten
     * @throws IOException if it cannot be written
     * @throws IllegalArgumentException if the name is invalid or in use
     */
    void save(String name, SoccerField field, Checkpoint moment, boolean replace) throws IOException;

    /**
     * Loads a scene.
     *
     * @param name its name
     * @return the checkpoint
     * @throws IOException if it cannot be read
     * @throws IllegalArgumentException if it is missing or damaged
     */
    Checkpoint load(String name) throws IOException;

    /**
     * Renames a scene.
     *
     * @param from the old name
     * @param to the new name
     * @throws IOException if the scene cannot be renamed
     * @throws IllegalArgumentException if there is no such scene, or the new name is invalid or in use
     */
    void rename(String from, String to) throws IOException;

    /**
     * Deletes a scene.
     *
     * @param name its name
     * @return a handle by which the scene can be restored
     * @throws IOException if it cannot be deleted
     * @throws IllegalArgumentException if there is no such scene
     */
    Removed remove(String name) throws IOException;

    /**
     * Creates the exception for a name in use.
     *
     * @param name the name
     * @return the exception
     */
    static IllegalArgumentException taken(String name) {
        return new IllegalArgumentException("There is already a scene named \"" + name + "\". Choose another name.");
    }

    /**
     * Creates the exception for a missing scene.
     *
     * @param name its name
     * @return the exception
     */
    static IllegalArgumentException gone(String name) {
        return new IllegalArgumentException("The scene \"" + name + "\" no longer exists. Reload the page.");
    }

    /**
     * Creates the exception for a damaged scene.
     *
     * @param name its name
     * @return the exception
     */
    static IllegalArgumentException damaged(String name) {
        return new IllegalArgumentException("The scene \"" + name + "\" is damaged.");
    }
}

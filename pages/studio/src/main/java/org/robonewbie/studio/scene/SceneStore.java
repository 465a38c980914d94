package org.robonewbie.studio.scene;

import java.io.IOException;
import java.util.List;
import org.robonewbie.nao.SoccerField;

/** Where scenes are kept, each with a name of its own. */
public interface SceneStore {

    /** How a scene comes back that was taken away. */
    interface Removed {

        /**
         * Brings the scene back.
         *
         * @throws IOException if it cannot be written
         * @throws IllegalArgumentException if its name is taken meanwhile; the message says so
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
     * @param moment what is kept
     * @param replace whether an older scene of this name is overwritten
     * @throws IOException if it cannot be written
     * @throws IllegalArgumentException if the name is impossible or taken; the message says so
     */
    void save(String name, SoccerField field, Checkpoint moment, boolean replace) throws IOException;

    /**
     * Reads a scene.
     *
     * @param name its name
     * @return what was kept
     * @throws IOException if it cannot be read
     * @throws IllegalArgumentException if there is none or it is damaged; the message says so
     */
    Checkpoint load(String name) throws IOException;

    /**
     * Gives a scene another name.
     *
     * @param from its name
     * @param to its name from now on
     * @throws IOException if that cannot be written
     * @throws IllegalArgumentException if there is no such scene, or the other name is impossible or taken; the message says so
     */
    void rename(String from, String to) throws IOException;

    /**
     * Takes a scene away.
     *
     * @param name its name
     * @return how it comes back
     * @throws IOException if that cannot be written
     * @throws IllegalArgumentException if there is no such scene; the message says so
     */
    Removed remove(String name) throws IOException;

    /**
     * Refuses a name that another scene has.
     *
     * @param name the name
     * @return what to throw
     */
    static IllegalArgumentException taken(String name) {
        return new IllegalArgumentException("There is a scene \"" + name + "\" already. Choose another name.");
    }

    /**
     * Refuses a scene that is not there.
     *
     * @param name its name
     * @return what to throw
     */
    static IllegalArgumentException gone(String name) {
        return new IllegalArgumentException("There is no scene \"" + name + "\" any more. Load the page again.");
    }

    /**
     * Refuses a scene that cannot be read.
     *
     * @param name its name
     * @return what to throw
     */
    static IllegalArgumentException damaged(String name) {
        return new IllegalArgumentException("The scene \"" + name + "\" is damaged.");
    }
}

package org.robonewbie.studio.scene;

import java.io.IOException;

/**
 * An undoable change to the saved scenes.
 *
 * @param name description of the change
 * @param undoing undoes the change
 * @param redoing redoes the change
 */
record SceneCommand(String name, Step undoing, Step redoing) implements UndoableCommand {

    /** A change to the saved scenes. */
    interface Step {
        void run() throws IOException;
    }

    @Override
    public String undo() throws IOException {
        undoing.run();
        return "";
    }

    @Override
    public String redo() throws IOException {
        redoing.run();
        return "";
    }
}

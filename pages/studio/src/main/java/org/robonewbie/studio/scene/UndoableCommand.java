package org.robonewbie.studio.scene;

import java.io.IOException;

/** A change to the world or to a file that can be undone. */
public interface UndoableCommand {

    /** {@return a description such as "ball moved"} */
    String name();

    /**
     * Undoes the change.
     *
     * @return a remark for the user; empty if the previous state is restored exactly
     * @throws IOException if a file cannot be changed; the message gives the reason
     */
    String undo() throws IOException;

    /**
     * Redoes the change after it was undone.
     *
     * @return a remark for the user; empty if the later state is restored exactly
     * @throws IOException if a file cannot be changed; the message gives the reason
     */
    String redo() throws IOException;
}

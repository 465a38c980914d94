package org.robonewbie.studio.scene;

import java.io.IOException;

/** Something that a person has done to the world or to a file, and that can be taken back. */
public interface UndoableCommand {

    /** {@return what was done, in words such as "ball moved"} */
    String name();

    /**
     * Takes the change back.
     *
     * @return what people should know of it; empty if all is as it was before
     * @throws IOException if a file cannot be changed; the message says why
     */
    String undo() throws IOException;

    /**
     * Does it once more after it was taken back.
     *
     * @return what people should know of it; empty if all is as it was after it
     * @throws IOException if a file cannot be changed; the message says why
     */
    String redo() throws IOException;
}

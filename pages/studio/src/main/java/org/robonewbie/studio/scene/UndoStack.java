package org.robonewbie.studio.scene;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;

/**
 * The last changes made in the studio, so that each can be taken back and done again, the newest first. A new change makes
 * an end of those that were taken back. Used by one thread at a time.
 */
public final class UndoStack {

    /** More than one remembers; the state of a world with 22 robots takes some hundred kilobytes. */
    static final int MOST = 50;

    private final Deque<UndoableCommand> done = new ArrayDeque<>();
    private final Deque<UndoableCommand> undone = new ArrayDeque<>();

    /**
     * Remembers a change.
     *
     * @param command what was just done
     */
    public void add(UndoableCommand command) {
        undone.clear();
        done.push(command);
        if (done.size() > MOST) {
            done.removeLast();
        }
    }

    /** Forgets everything, since another world is there. */
    public void clear() {
        done.clear();
        undone.clear();
    }

    /** {@return the name of what would be taken back; empty for nothing} */
    public String nextUndo() {
        return Optional.ofNullable(done.peek()).map(UndoableCommand::name).orElse("");
    }

    /** {@return the name of what would be done again; empty for nothing} */
    public String nextRedo() {
        return Optional.ofNullable(undone.peek()).map(UndoableCommand::name).orElse("");
    }

    /**
     * Takes the newest change back.
     *
     * @return what has happened, as a sentence
     * @throws IOException if a file cannot be changed; the change stays done
     */
    public String undo() throws IOException {
        UndoableCommand command = done.peek();
        if (command == null) {
            return "There is nothing to undo.";
        }
        String remark = command.undo();
        undone.push(done.pop());
        return sentence("Undone: ", command, remark);
    }

    /**
     * Does the change again that was taken back last.
     *
     * @return what has happened, as a sentence
     * @throws IOException if a file cannot be changed; the change stays undone
     */
    public String redo() throws IOException {
        UndoableCommand command = undone.peek();
        if (command == null) {
            return "There is nothing to redo.";
        }
        String remark = command.redo();
        done.push(undone.pop());
        return sentence("Done again: ", command, remark);
    }

    private static String sentence(String beginning, UndoableCommand command, String remark) {
        return beginning + command.name() + "." + (remark.isEmpty() ? "" : " " + remark);
    }
}

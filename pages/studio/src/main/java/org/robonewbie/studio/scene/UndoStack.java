package org.robonewbie.studio.scene;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;

/**
 * Undo and redo stacks of bounded size. A new change clears the redo stack. Not thread-safe.
 */
public final class UndoStack {

    /** Maximum number of changes. Each may hold a state of the world, several hundred kilobytes with 22 robots. */
    static final int CAPACITY = 50;

    private final Deque<UndoableCommand> done = new ArrayDeque<>();
    private final Deque<UndoableCommand> undone = new ArrayDeque<>();

    /**
     * Pushes a change.
     *
     * @param command a command that has just been executed
     */
    public void add(UndoableCommand command) {
        undone.clear();
        done.push(command);
        if (done.size() > CAPACITY) {
            done.removeLast();
        }
    }

    /** Clears both stacks; called when another world is shown. */
    public void clear() {
        done.clear();
        undone.clear();
    }

    /** {@return the name of the next command to undo; empty for none} */
    public String nextUndo() {
        return Optional.ofNullable(done.peek()).map(UndoableCommand::name).orElse("");
    }

    /** {@return the name of the next command to redo; empty for none} */
    public String nextRedo() {
        return Optional.ofNullable(undone.peek()).map(UndoableCommand::name).orElse("");
    }

    /**
     * Undoes the latest change.
     *
     * @return a sentence for the user
     * @throws IOException if a file cannot be changed; the change is not undone
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
     * Redoes the most recently undone change.
     *
     * @return a sentence for the user
     * @throws IOException if a file cannot be changed; the change is not redone
     */
    public String redo() throws IOException {
        UndoableCommand command = undone.peek();
        if (command == null) {
            return "There is nothing to redo.";
        }
        String remark = command.redo();
        done.push(undone.pop());
        return sentence("Redone: ", command, remark);
    }

    private static String sentence(String beginning, UndoableCommand command, String remark) {
        return beginning + command.name() + "." + (remark.isEmpty() ? "" : " " + remark);
    }
}

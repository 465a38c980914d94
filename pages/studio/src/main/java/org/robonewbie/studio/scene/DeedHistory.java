package org.robonewbie.studio.scene;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;

/**
 * The last deeds of all people at the studio, so that each can be taken back and done again, the newest first. A new deed makes
 * an end of those that were taken back. Used by one thread at a time.
 */
public final class DeedHistory {

    /** More than one remembers; the state of a world with 22 robots takes some hundred kilobytes. */
    static final int MOST = 50;

    private final Deque<Deed> done = new ArrayDeque<>();
    private final Deque<Deed> undone = new ArrayDeque<>();

    /**
     * Remembers a deed.
     *
     * @param deed what was just done
     */
    public void add(Deed deed) {
        undone.clear();
        done.push(deed);
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
        return Optional.ofNullable(done.peek()).map(Deed::name).orElse("");
    }

    /** {@return the name of what would be done again; empty for nothing} */
    public String nextRedo() {
        return Optional.ofNullable(undone.peek()).map(Deed::name).orElse("");
    }

    /**
     * Takes the newest deed back.
     *
     * @return what has happened, as a sentence
     * @throws IOException if a file cannot be changed; the deed stays done
     */
    public String undo() throws IOException {
        Deed deed = done.peek();
        if (deed == null) {
            return "There is nothing to undo.";
        }
        String remark = deed.undo();
        undone.push(done.pop());
        return sentence("Undone: ", deed, remark);
    }

    /**
     * Does the deed again that was taken back last.
     *
     * @return what has happened, as a sentence
     * @throws IOException if a file cannot be changed; the deed stays undone
     */
    public String redo() throws IOException {
        Deed deed = undone.peek();
        if (deed == null) {
            return "There is nothing to redo.";
        }
        String remark = deed.redo();
        done.push(undone.pop());
        return sentence("Done again: ", deed, remark);
    }

    private static String sentence(String beginning, Deed deed, String remark) {
        return beginning + deed.name() + "." + (remark.isEmpty() ? "" : " " + remark);
    }
}

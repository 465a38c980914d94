package org.robonewbie.studio;

import java.util.Optional;
import org.robonewbie.studio.scene.Checkpoint;
import org.robonewbie.studio.scene.UndoableCommand;

/** Undoable change to the world; undoing it restores the checkpoint that was taken before the change. */
final class WorldChange implements UndoableCommand {

    private final Restore world;
    private final String name;
    private final long gesture;
    private final Checkpoint before;
    private Optional<Checkpoint> after = Optional.empty();

    /**
     * Takes a checkpoint before a change.
     *
     * @param world the running simulation
     * @param name description of the change
     * @param gesture number of the drag to which the change belongs; 0 for none
     */
    WorldChange(Restore world, String name, long gesture) {
        this.world = world;
        this.name = name;
        this.gesture = gesture;
        this.before = world.keep();
    }

    /** Returns whether a command continues the same drag. */
    boolean continues(String otherName, long otherGesture) {
        return gesture != 0 && gesture == otherGesture && name.equals(otherName);
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public String undo() {
        Checkpoint now = world.keep();
        String remark = world.goBackTo(before, false);
        after = Optional.of(now);
        return remark;
    }

    @Override
    public String redo() {
        return world.goBackTo(after.orElseThrow(), false);
    }
}

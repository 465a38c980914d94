package org.robonewbie.studio;

import java.io.IOException;
import java.util.Optional;
import java.util.function.Consumer;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.state.WorldState;
import org.robonewbie.studio.scene.Checkpoint;
import org.robonewbie.studio.scene.RestorableSimulation;
import org.robonewbie.studio.scene.UndoStack;
import org.robonewbie.studio.scene.UndoableCommand;

/**
 * Executes, undoes and redoes the user's changes to the world, one at a time. A checkpoint is taken before each
 * change.
 */
final class UndoManager implements RestorableSimulation {

    private final StudioContext context;
    private final Restore world;
    private final Consumer<String> notifier;
    private final UndoStack history = new UndoStack();
    private Optional<WorldChange> last = Optional.empty();
    private volatile Names names = new Names("", "");

    /** Names of the commands that would be undone and redone next; empty for none. */
    record Names(String undo, String redo) {}

    /**
     * Creates a manager with an empty history.
     *
     * @param context the objects on which the commands operate
     * @param notifier receives messages to the user
     */
    UndoManager(StudioContext context, Consumer<String> notifier) {
        this.context = context;
        this.world = new Restore(context);
        this.notifier = notifier;
    }

    Names names() {
        return names;
    }

    /**
     * Applies an undoable change.
     *
     * @param name description such as "ball moved"
     * @param gesture number of the drag, 0 for none; all changes of one drag are undone together
     * @param act applies the change
     */
    void change(String name, long gesture, Runnable act) {
        if (!context.simulation().hasClock() || context.simulation().trial().isPresent()) {
            act.run();
            return;
        }
        later(() -> {
            if (last.filter(change -> change.continues(name, gesture)).isEmpty()) {
                remember(new WorldChange(world, name, gesture));
            }
            act.run();
        });
    }

    /** Records that a puppet was added. */
    void puppetAdded(PlayerNumber player) {
        done(new UndoableCommand() {
            @Override
            public String name() {
                return "puppet added";
            }

            @Override
            public String undo() {
                context.puppets().remove(player);
                return "";
            }

            @Override
            public String redo() {
                context.puppets().add(player.side(), context.now());
                return "";
            }
        });
    }

    /** Removes a puppet; if this is undone, the puppet rejoins at its former position. */
    void removePuppet(PlayerNumber player) {
        later(() -> {
            Checkpoint before = world.keep();
            context.puppets().remove(player);
            last = Optional.empty();
            history.add(new UndoableCommand() {
                @Override
                public String name() {
                    return "puppet removed";
                }

                @Override
                public String undo() {
                    return world.goBackTo(before, true);
                }

                @Override
                public String redo() {
                    context.puppets().remove(player);
                    return "";
                }
            });
        });
    }

    /** Records a change to a file. */
    void done(UndoableCommand command) {
        later(() -> {
            last = Optional.empty();
            history.add(command);
        });
    }

    private void remember(WorldChange change) {
        last = Optional.of(change);
        history.add(change);
    }

    void undo() {
        later(() -> notifier.accept(attempt(history::undo)));
    }

    void redo() {
        later(() -> notifier.accept(attempt(history::redo)));
    }

    /** Clears the history; called when another world is shown. */
    void forget() {
        later(() -> {
            last = Optional.empty();
            history.clear();
        });
    }

    private interface Step {
        String take() throws IOException;
    }

    private String attempt(Step step) {
        last = Optional.empty();
        try {
            return step.take();
        } catch (IOException | IllegalStateException | IllegalArgumentException refused) {
            return "That cannot be undone: " + refused.getMessage();
        }
    }

    private void later(Runnable work) {
        context.commandQueue().later(() -> {
            run(work);
            nameNext();
        });
    }

    private void nameNext() {
        names = new Names(history.nextUndo(), history.nextRedo());
    }

    private void run(Runnable work) {
        try {
            work.run();
        } catch (IllegalStateException | IllegalArgumentException refused) {
            notifier.accept(String.valueOf(refused.getMessage()));
        }
    }

    @Override
    public SoccerField field() {
        return world.field();
    }

    @Override
    public WorldSnapshot now() {
        return world.now();
    }

    @Override
    public Optional<WorldState> save() {
        return world.save();
    }

    @Override
    public Restored restore(Checkpoint moment) {
        return context.commandQueue().result(() -> {
            WorldChange change = new WorldChange(world, "scene loaded", 0);
            Restored restored = world.restore(moment);
            remember(change);
            nameNext();
            return restored;
        });
    }
}

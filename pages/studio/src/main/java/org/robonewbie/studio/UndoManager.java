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
 * What people do to the world, one thing after the other, so that each can be taken back. Each change waits until the moment before
 * it is kept.
 */
final class UndoManager implements RestorableSimulation {

    private final StudioContext context;
    private final Restore world;
    private final Consumer<String> teller;
    private final UndoStack history = new UndoStack();
    private Optional<WorldChange> last = Optional.empty();
    private volatile Names names = new Names("", "");

    /** What would be undone and redone; empty for nothing. */
    record Names(String undo, String redo) {}

    /**
     * Prepares to remember.
     *
     * @param context what can be acted upon
     * @param teller tells people what has happened
     */
    UndoManager(StudioContext context, Consumer<String> teller) {
        this.context = context;
        this.world = new Restore(context);
        this.teller = teller;
    }

    Names names() {
        return names;
    }

    /**
     * Changes the world.
     *
     * @param name what is done, such as "ball moved"
     * @param gesture number of the drag that it belongs to: all changes of a drag are one change; 0 if it is none
     * @param act gives the orders
     */
    void change(String name, long gesture, Runnable act) {
        if (!context.simulation().hasClock() || context.simulation().trial().isPresent()) {
            act.run();
            return;
        }
        later(() -> {
            if (last.filter(change -> change.goesOnWith(name, gesture)).isEmpty()) {
                remember(new WorldChange(world, name, gesture));
            }
            act.run();
        });
    }

    /** Remembers that a puppet was added, which is undone by taking it away. */
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

    /** Takes a puppet away, which is undone by letting it in once more, at the place that it had. */
    void removePuppet(PlayerNumber player) {
        later(() -> {
            Checkpoint before = world.keep();
            context.puppets().remove(player);
            last = Optional.empty();
            history.add(new UndoableCommand() {
                @Override
                public String name() {
                    return "puppet taken away";
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

    /** Remembers what was done to a file. */
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
        later(() -> teller.accept(told(history::undo)));
    }

    void redo() {
        later(() -> teller.accept(told(history::redo)));
    }

    /** Forgets everything, since another world is shown. */
    void forget() {
        later(() -> {
            last = Optional.empty();
            history.clear();
        });
    }

    private interface Step {
        String take() throws IOException;
    }

    private String told(Step step) {
        last = Optional.empty();
        try {
            return step.take();
        } catch (IOException | IllegalStateException | IllegalArgumentException refused) {
            return "That cannot be undone: " + refused.getMessage();
        }
    }

    private void later(Runnable work) {
        context.commandQueue().later(() -> {
            carryOut(work);
            nameNext();
        });
    }

    private void nameNext() {
        names = new Names(history.nextUndo(), history.nextRedo());
    }

    private void carryOut(Runnable work) {
        try {
            work.run();
        } catch (IllegalStateException | IllegalArgumentException refused) {
            teller.accept(String.valueOf(refused.getMessage()));
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
    public Restored goOnFrom(Checkpoint moment) {
        return context.commandQueue().result(() -> {
            WorldChange change = new WorldChange(world, "scene loaded", 0);
            Restored restored = world.goOnFrom(moment);
            remember(change);
            nameNext();
            return restored;
        });
    }
}

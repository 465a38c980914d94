package org.robonewbie.studio;

import java.util.Optional;
import java.util.function.Consumer;
import org.robonewbie.protocol.telemetry.TuningRequests;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.WorldSnapshot;

/** Context of a page whose world runs on the same thread. */
final class SteppedContext implements StudioContext {

    private final PageFeed.World world;
    private final CommandQueue commandQueue = new InlineCommandQueue();
    private final TuningRequests numbers = new TuningRequests();
    private final PuppetService puppets;
    private final UndoManager undoManager;

    /**
     * Creates a context.
     *
     * @param world the world, which need not have started
     * @param notifier receives messages to the user
     */
    SteppedContext(PageFeed.World world, Consumer<String> notifier) {
        this.world = world;
        puppets = new PuppetService(world, Optional.of(world));
        undoManager = new UndoManager(this, notifier);
    }

    @Override
    public SimulationControl simulation() {
        return world;
    }

    @Override
    public UndoManager undoManager() {
        return undoManager;
    }

    @Override
    public CommandQueue commandQueue() {
        return commandQueue;
    }

    @Override
    public TuningRequests numbers() {
        return numbers;
    }

    @Override
    public PuppetService puppets() {
        return puppets;
    }

    @Override
    public WorldSnapshot now() {
        return world.now();
    }
}

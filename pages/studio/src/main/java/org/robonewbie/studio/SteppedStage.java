package org.robonewbie.studio;

import java.util.Optional;
import java.util.function.Consumer;
import org.robonewbie.protocol.telemetry.NumberWishes;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.WorldSnapshot;

/** What a page can act upon whose world runs on the same thread. */
final class SteppedStage implements Stage {

    private final PageFeed.World world;
    private final WaitingRoom waitingRoom = new EmptyWaitingRoom();
    private final NumberWishes numbers = new NumberWishes();
    private final PuppetDesk puppets;
    private final Deeds deeds;

    /**
     * Opens the stage.
     *
     * @param world the world, which need not have begun
     * @param teller tells people what has happened
     */
    SteppedStage(PageFeed.World world, Consumer<String> teller) {
        this.world = world;
        puppets = new PuppetDesk(world, Optional.of(world));
        deeds = new Deeds(this, teller);
    }

    @Override
    public SimulationControl simulation() {
        return world;
    }

    @Override
    public Deeds deeds() {
        return deeds;
    }

    @Override
    public WaitingRoom waitingRoom() {
        return waitingRoom;
    }

    @Override
    public NumberWishes numbers() {
        return numbers;
    }

    @Override
    public PuppetDesk puppets() {
        return puppets;
    }

    @Override
    public WorldSnapshot now() {
        return world.now();
    }
}

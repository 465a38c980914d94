package org.robonewbie.simulator.server;

import org.jspecify.annotations.Nullable;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.WorldSnapshot;

/** Keeps the latest snapshot. */
final class WorldWatcher implements SimulationObserver {

    private volatile @Nullable WorldSnapshot latest;

    @Override
    public void cycleEnded(WorldSnapshot snapshot) {
        latest = snapshot;
    }

    WorldSnapshot latest() {
        WorldSnapshot snapshot = latest;
        if (snapshot == null) {
            throw new IllegalStateException("There was no snapshot yet");
        }
        return snapshot;
    }
}

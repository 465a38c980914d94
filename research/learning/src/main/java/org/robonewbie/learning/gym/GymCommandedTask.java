package org.robonewbie.learning.gym;

import java.util.Optional;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.Trial;

/**
 * A robot is told a velocity, and perhaps another one every 3 s. The options {@code forward}, {@code left} and {@code turn} set one
 * for the whole episode.
 */
abstract class GymCommandedTask extends GymTask {

    private static final int CYCLES_OF_COMMAND = 150;

    private Optional<WalkVelocity> fixed = Optional.empty();
    private WalkVelocity wanted = WalkVelocity.ZERO;
    private int cycle;

    /** Draws the next velocity; the one before is zero at first. */
    abstract WalkVelocity any(RandomSource random, WalkVelocity before);

    @Override
    protected final void takeCommand(WalkVelocity command) {
        fixed = Optional.of(command);
    }

    @Override
    public void begin(Trial trial) {
        choose();
    }

    @Override
    public final void act(Trial trial) {
        cycle++;
        if (cycle % CYCLES_OF_COMMAND == 0) {
            choose();
        }
    }

    private void choose() {
        wanted = fixed.orElseGet(() -> any(chance(), wanted));
    }

    @Override
    protected final WalkVelocity velocity() {
        return wanted;
    }
}

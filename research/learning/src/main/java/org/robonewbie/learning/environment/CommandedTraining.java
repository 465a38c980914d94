package org.robonewbie.learning.environment;

import java.util.Optional;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.Trial;

/**
 * Follow a commanded velocity, perhaps another one every 3 s. The options {@code forward}, {@code left} and {@code turn} set one for
 * the whole episode.
 */
abstract class CommandedTraining extends TrainingTask {

    static final int CYCLES_PER_COMMAND = 150;

    private Optional<WalkVelocity> fixed = Optional.empty();
    private WalkVelocity wanted = WalkVelocity.ZERO;
    private int cycle;

    /** Draws the next velocity; the one before is zero at first. */
    abstract WalkVelocity any(RandomSource random, WalkVelocity before);

    /** How many cycles have ended. */
    final int cycle() {
        return cycle;
    }

    @Override
    protected final void takeCommand(WalkVelocity command) {
        fixed = Optional.of(command);
    }

    @Override
    public void begin(Trial trial) {
        choose();
    }

    @Override
    public void act(Trial trial) {
        cycle++;
        if (cycle % CYCLES_PER_COMMAND == 0) {
            choose();
        }
    }

    private void choose() {
        wanted = fixed.orElseGet(() -> any(random(), wanted));
    }

    @Override
    protected WalkVelocity velocity() {
        return wanted;
    }
}

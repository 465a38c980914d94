package org.robonewbie.learning.environment;

import java.util.Optional;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.Trial;

/**
 * Base class for tasks in which the robot follows a commanded velocity, which is redrawn every 3 s. The options
 * {@code forward}, {@code left} and {@code turn} set a constant command instead.
 */
abstract class CommandedTraining extends TrainingTask {

    static final int CYCLES_PER_COMMAND = 150;

    private Optional<WalkVelocity> constant = Optional.empty();
    private WalkVelocity command = WalkVelocity.ZERO;
    private int cycle;

    /** Draws the next command from the previous one, which is zero at first. */
    abstract WalkVelocity draw(RandomSource random, WalkVelocity previous);

    /** Returns the number of completed cycles. */
    final int cycle() {
        return cycle;
    }

    @Override
    protected final void setCommand(WalkVelocity velocity) {
        constant = Optional.of(velocity);
    }

    @Override
    public void begin(Trial trial) {
        nextCommand();
    }

    @Override
    public void act(Trial trial) {
        cycle++;
        if (cycle % CYCLES_PER_COMMAND == 0) {
            nextCommand();
        }
    }

    private void nextCommand() {
        command = constant.orElseGet(() -> draw(random(), command));
    }

    @Override
    protected WalkVelocity velocity() {
        return command;
    }
}

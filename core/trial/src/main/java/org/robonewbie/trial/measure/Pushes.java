package org.robonewbie.trial.measure;

import java.util.Random;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.TrialHook;

/** Pushes the first robot from changing directions, each time harder. The same seed pushes in the same way. */
public final class Pushes implements TrialHook {

    private static final int CYCLES_OF_A_PUSH = 5;

    private final Random random;
    private final int cyclesBetween;
    private final double stepNewtons;
    private int cycle;
    private int pushes;
    private Vector3 push = Vector3.ZERO;

    /**
     * Prepares pushes of a tenth of a second each.
     *
     * @param seed chooses their directions
     * @param cyclesBetween cycles from one push to the next
     * @param stepNewtons strength of the first push, and by how much each one is harder than the one before
     */
    public Pushes(long seed, int cyclesBetween, double stepNewtons) {
        this.random = new Random(seed);
        this.cyclesBetween = cyclesBetween;
        this.stepNewtons = stepNewtons;
    }

    @Override
    public void act(Trial trial) {
        cycle++;
        if (cycle % cyclesBetween == 0) {
            pushes++;
            double angle = 2 * Math.PI * random.nextDouble();
            push = new Vector3(PortableMath.cos(angle), PortableMath.sin(angle), 0).times(pushes * stepNewtons);
        }
        if (pushes > 0 && cycle % cyclesBetween < CYCLES_OF_A_PUSH) {
            trial.robot(0).push(push);
        }
    }

    /** {@return how many pushes have begun} */
    public int count() {
        return pushes;
    }
}

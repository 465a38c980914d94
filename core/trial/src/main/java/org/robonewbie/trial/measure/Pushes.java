package org.robonewbie.trial.measure;

import java.util.Optional;
import java.util.Random;
import java.util.function.DoubleSupplier;
import java.util.function.IntFunction;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.TrialHook;

/** Pushes the first robot in random directions for 0.1 s each. The same seed gives the same pushes. */
public final class Pushes implements TrialHook {

    private static final int CYCLES_PER_PUSH = 5;
    private static final int CYCLES_PER_SECOND = 50;

    private final IntFunction<Vector3> forces;
    private final int cyclesBetween;
    private int cycle;
    private int pushes;
    private Vector3 push = Vector3.ZERO;

    private Pushes(IntFunction<Vector3> forces, int cyclesBetween, int firstCycle) {
        this.forces = forces;
        this.cyclesBetween = cyclesBetween;
        this.cycle = cyclesBetween - firstCycle;
    }

    /**
     * Creates pushes whose force increases linearly.
     *
     * @param seed seed of the directions
     * @param cyclesBetween number of cycles from one push to the next
     * @param stepNewtons force of the first push, and the increase from each push to the next
     * @return the pushes
     */
    public static Pushes growing(long seed, int cyclesBetween, double stepNewtons) {
        Random random = new Random(seed);
        return new Pushes(
                number -> direction(random.nextDouble()).times(number * stepNewtons), cyclesBetween, cyclesBetween);
    }

    /**
     * Creates pushes with equal forces, one in the last 0.1 s of each second.
     *
     * @param fractions source of random numbers from 0 to 1, which determine the directions
     * @param newtons force
     * @return the pushes
     */
    public static Pushes equal(DoubleSupplier fractions, double newtons) {
        return new Pushes(
                number -> direction(fractions.getAsDouble()).times(newtons),
                CYCLES_PER_SECOND,
                CYCLES_PER_SECOND - CYCLES_PER_PUSH + 1);
    }

    /**
     * Creates pushes with random forces, one at the end of each second.
     *
     * @param random source of directions and forces
     * @param maxNewtons maximum force
     * @return the pushes
     */
    public static Pushes random(Random random, double maxNewtons) {
        return random(random::nextDouble, maxNewtons);
    }

    /**
     * Creates pushes with random forces, one at the end of each second.
     *
     * @param fractions source of random numbers from 0 to 1, which determine directions and forces
     * @param maxNewtons maximum force
     * @return the pushes
     */
    public static Pushes random(DoubleSupplier fractions, double maxNewtons) {
        return new Pushes(
                number -> new Pose2d(0, 0, fractions.getAsDouble() * 360)
                        .point(maxNewtons * fractions.getAsDouble(), 0, 0),
                CYCLES_PER_SECOND,
                CYCLES_PER_SECOND - CYCLES_PER_PUSH);
    }

    private static Vector3 direction(double fraction) {
        double angle = 2 * Math.PI * fraction;
        return new Vector3(PortableMath.cos(angle), PortableMath.sin(angle), 0);
    }

    @Override
    public void act(Trial trial) {
        cycle++;
        at(cycle).ifPresent(trial.robot(0)::push);
    }

    /**
     * Returns the force of a cycle. Ask for each cycle in turn.
     *
     * @param now number of the cycle; a push begins in each multiple of the number of cycles between pushes
     * @return the force on each robot that is to be pushed; empty between pushes
     */
    public Optional<Vector3> at(long now) {
        if (now > 0 && now % cyclesBetween == 0) {
            pushes++;
            push = forces.apply(pushes);
        }
        return pushes > 0 && now % cyclesBetween < CYCLES_PER_PUSH ? Optional.of(push) : Optional.empty();
    }

    /** {@return the number of pushes so far} */
    public int count() {
        return pushes;
    }
}

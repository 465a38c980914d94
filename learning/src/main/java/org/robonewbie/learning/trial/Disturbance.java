package org.robonewbie.learning.trial;

import java.util.Random;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.motion.Posture;

/**
 * What makes one trial different from the next: joints that are not quite where they should be, and a hand that pushes the
 * torso for a tenth of a second in each second. The same seed disturbs in the same way.
 */
public final class Disturbance implements TrialObserver {

    private static final int CYCLES_BETWEEN = 50;
    private static final int CYCLES_OF_PUSH = 5;

    private final Random random;
    private final double newtons;
    private int cycle;
    private Vector3 push = Vector3.ZERO;

    /**
     * Prepares a trial.
     *
     * @param seed chooses the disturbances
     * @param newtons strength of the pushes
     */
    public Disturbance(long seed, double newtons) {
        this.random = new Random(seed);
        this.newtons = newtons;
        random.nextLong();
    }

    /**
     * Draws a posture near another one.
     *
     * @param posture the right posture
     * @param degrees standard deviation of each joint from it
     * @return a posture within the joints' ranges
     */
    public Posture near(Posture posture, double degrees) {
        double[] angles = posture.toArray();
        for (Joint joint : Joint.values()) {
            angles[joint.ordinal()] += degrees * random.nextGaussian();
        }
        return Posture.of(angles).clamped();
    }

    @Override
    public boolean goOn(TrialRobot robot) {
        int phase = cycle % CYCLES_BETWEEN;
        if (phase == 0) {
            double direction = 2 * Math.PI * random.nextDouble();
            push = new Vector3(newtons * Math.cos(direction), newtons * Math.sin(direction), 0);
        }
        if (phase >= CYCLES_BETWEEN - CYCLES_OF_PUSH) {
            robot.push(push);
        }
        cycle++;
        return true;
    }
}

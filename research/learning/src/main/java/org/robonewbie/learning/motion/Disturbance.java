package org.robonewbie.learning.motion;

import java.util.Random;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.TrialHook;

/**
 * Random variation of trials: joint offsets in the initial posture, and a push against the torso for 0.1 s once per
 * second.
 */
final class Disturbance implements TrialHook {

    private static final int CYCLES_PER_PUSH = 50;
    private static final int PUSH_CYCLES = 5;

    private final Random random;
    private final double newtons;
    private int cycle;
    private Vector3 push = Vector3.ZERO;

    Disturbance(long seed, double newtons) {
        this.random = new Random(seed);
        this.newtons = newtons;
        random.nextLong();
    }

    /** Returns a posture with normally distributed offsets added to its joint angles. */
    Posture near(Posture posture, double degrees) {
        double[] angles = posture.toArray();
        for (Joint joint : Joint.values()) {
            angles[joint.ordinal()] += degrees * random.nextGaussian();
        }
        return Posture.of(angles).clamped();
    }

    @Override
    public void act(Trial trial) {
        int phase = cycle % CYCLES_PER_PUSH;
        if (phase == 0) {
            double direction = 2 * Math.PI * random.nextDouble();
            push = new Vector3(PortableMath.cos(direction), PortableMath.sin(direction), 0).times(newtons);
        }
        if (phase >= CYCLES_PER_PUSH - PUSH_CYCLES && newtons > 0) {
            trial.robot(0).push(push);
        }
        cycle++;
    }
}

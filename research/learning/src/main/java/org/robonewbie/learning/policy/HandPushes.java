package org.robonewbie.learning.policy;

import java.util.Random;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.trial.Trial;

/** A hand that pushes the first robot for a tenth of a second in each second, into any direction and with any strength up to the hardest. */
final class HandPushes {

    private static final int CYCLES_BETWEEN = 50;
    private static final int CYCLES_OF_PUSH = 5;

    private final Random random;
    private final double newtons;
    private Vector3 push = Vector3.ZERO;

    HandPushes(Random random, double newtons) {
        this.random = random;
        this.newtons = newtons;
    }

    /** Acts before a cycle. */
    void act(Trial room, int cycle) {
        int phase = cycle % CYCLES_BETWEEN;
        if (phase == 0) {
            Pose2d centre = new Pose2d(0, 0, random.nextDouble() * 360);
            push = centre.point(newtons * random.nextDouble(), 0, 0);
        }
        if (phase >= CYCLES_BETWEEN - CYCLES_OF_PUSH && newtons > 0) {
            room.robot(0).push(push);
        }
    }
}

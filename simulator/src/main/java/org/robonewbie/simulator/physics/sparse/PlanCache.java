package org.robonewbie.simulator.physics.sparse;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Remembers elimination plans, since limbs touch the ground in the same few ways again and again. */
final class PlanCache {

    private static final int MOST_PLANS = 64;

    private final List<EliminationPlan> plans = new ArrayList<>();
    private int[] key = {};
    private int oldest;

    EliminationPlan planFor(List<Joint> joints, int bodies) {
        int length = writeKey(joints);
        for (int i = 0; i < plans.size(); i++) {
            if (plans.get(i).suits(key, length)) {
                return plans.get(i);
            }
        }
        EliminationPlan plan = new EliminationPlan(Arrays.copyOf(key, length), bodies);
        remember(plan);
        return plan;
    }

    private int writeKey(List<Joint> joints) {
        int length = CouplingGraph.NUMBERS_PER_JOINT * joints.size();
        if (key.length < length) {
            key = new int[2 * length];
        }
        for (int i = 0; i < joints.size(); i++) {
            Joint joint = joints.get(i);
            int at = CouplingGraph.NUMBERS_PER_JOINT * i;
            key[at] = joint.first.islandIndex;
            key[at + 1] = joint.second == null ? CouplingGraph.FIXED : joint.second.islandIndex;
            key[at + 2] = joint.rowCount();
        }
        return length;
    }

    private void remember(EliminationPlan plan) {
        if (plans.size() < MOST_PLANS) {
            plans.add(plan);
        } else {
            plans.set(oldest, plan);
            oldest = (oldest + 1) % MOST_PLANS;
        }
    }
}

package org.robonewbie.simulator.physics.sparse;

import java.util.ArrayList;
import java.util.List;

/**
 * Remembers elimination plans, since limbs touch the ground in the same few ways again and again.
 *
 * <p>Piles of robots have large plans that hardly ever fit twice, but for a pile that lies still; so of these only the last
 * one is kept, until it has been of no use for some time, and all others together have a limit.
 */
final class PlanCache {

    private static final int MOST_PLANS = 64;
    private static final int MOST_NUMBERS = 1 << 18;
    private static final int LARGE = 1 << 15;
    private static final int PATIENCE = 2_000;

    private static final int MOST_SPENT = 16;

    /** The plan that was used last comes first. */
    private final List<EliminationPlan> plans = new ArrayList<>();
    /** Plans that made room for others and can be replaced; the one that went last comes last. */
    private final List<EliminationPlan> spent = new ArrayList<>();

    private CouplingGraph graph = new CouplingGraph();
    private EliminationPlan large = new EliminationPlan();
    private int useless;
    private int[] key = {};
    private int numbers;
    private long made;

    EliminationPlan planFor(List<ConstraintJoint> joints, int bodies) {
        int length = writeKey(joints);
        useless++;
        if (large.joints() > 0 && useless > PATIENCE) {
            forgetPile();
        }
        for (int i = 0; i < plans.size(); i++) {
            if (plans.get(i).suits(key, length)) {
                plans.add(0, plans.remove(i));
                return plans.get(0);
            }
        }
        if (large.suits(key, length)) {
            useless = 0;
            return large;
        }
        made++;
        EliminationPlan plan = takeSpent(joints.size());
        plan.make(key, length, bodies, graph);
        remember(plan);
        return plan;
    }

    /** How many plans have been made. */
    long made() {
        return made;
    }

    private void forgetPile() {
        large = new EliminationPlan();
        graph = new CouplingGraph();
        spent.clear();
    }

    /** Returns a plan that nobody needs any more and that is about as large as wanted, or else a new one. */
    private EliminationPlan takeSpent(int joints) {
        for (int i = spent.size() - 1; i >= 0; i--) {
            if (spent.get(i).hasRoomFor(joints)) {
                return spent.remove(i);
            }
        }
        return new EliminationPlan();
    }

    private void addSpent(EliminationPlan plan) {
        if (spent.size() == MOST_SPENT) {
            spent.remove(0);
        }
        spent.add(plan);
    }

    /** The memory that all plans but the large one take, in integers. */
    int numbers() {
        return numbers;
    }

    private int writeKey(List<ConstraintJoint> joints) {
        int length = CouplingGraph.NUMBERS_PER_JOINT * joints.size();
        if (key.length < length) {
            key = new int[2 * length];
        }
        for (int i = 0; i < joints.size(); i++) {
            ConstraintJoint joint = joints.get(i);
            int at = CouplingGraph.NUMBERS_PER_JOINT * i;
            key[at] = joint.first.islandIndex;
            key[at + 1] = joint.second == null ? CouplingGraph.FIXED : joint.second.islandIndex;
            key[at + 2] = joint.rowCount();
        }
        return length;
    }

    private void remember(EliminationPlan plan) {
        if (plan.numbers() > LARGE) {
            addSpent(large);
            large = plan;
            useless = 0;
            return;
        }
        plans.add(0, plan);
        numbers += plan.numbers();
        while (plans.size() > MOST_PLANS || numbers > MOST_NUMBERS) {
            EliminationPlan last = plans.remove(plans.size() - 1);
            numbers -= last.numbers();
            addSpent(last);
        }
    }
}

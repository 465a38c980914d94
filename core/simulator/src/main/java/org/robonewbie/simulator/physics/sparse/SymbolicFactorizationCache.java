package org.robonewbie.simulator.physics.sparse;

import java.util.ArrayList;
import java.util.List;

/**
 * Remembers symbolic factorizations, since limbs touch the ground in the same few ways again and again.
 *
 * <p>Piles of robots have large factorizations that hardly ever fit twice, but for a pile that lies still; so of these only the last
 * one is kept, until it has been of no use for some time, and all others together have a limit.
 */
final class SymbolicFactorizationCache {

    private static final int MAX_PLANS = 64;
    private static final int MAX_NUMBERS = 1 << 18;
    private static final int LARGE = 1 << 15;
    private static final int PATIENCE = 2_000;

    private static final int MAX_SPENT = 16;

    /** The factorization that was used last comes first. */
    private final List<SymbolicFactorization> factorizations = new ArrayList<>();
    /** Factorizations that made room for others and can be replaced; the one that went last comes last. */
    private final List<SymbolicFactorization> spent = new ArrayList<>();

    private CouplingGraph graph = new CouplingGraph();
    private SymbolicFactorization large = new SymbolicFactorization();
    private int useless;
    private int[] key = {};
    private int numbers;
    private long misses;

    SymbolicFactorization get(List<ConstraintJoint> joints, int bodies) {
        int length = writeKey(joints);
        useless++;
        if (large.joints() > 0 && useless > PATIENCE) {
            forgetPile();
        }
        for (int i = 0; i < factorizations.size(); i++) {
            if (factorizations.get(i).suits(key, length)) {
                factorizations.add(0, factorizations.remove(i));
                return factorizations.get(0);
            }
        }
        if (large.suits(key, length)) {
            useless = 0;
            return large;
        }
        misses++;
        SymbolicFactorization factorization = takeSpent(joints.size());
        factorization.make(key, length, bodies, graph);
        remember(factorization);
        return factorization;
    }

    /** How many factorizations were computed. */
    long misses() {
        return misses;
    }

    private void forgetPile() {
        large = new SymbolicFactorization();
        graph = new CouplingGraph();
        spent.clear();
    }

    /** Returns a factorization that is no longer needed and that is about as large as wanted, or else a new one. */
    private SymbolicFactorization takeSpent(int joints) {
        for (int i = spent.size() - 1; i >= 0; i--) {
            if (spent.get(i).hasRoomFor(joints)) {
                return spent.remove(i);
            }
        }
        return new SymbolicFactorization();
    }

    private void addSpent(SymbolicFactorization factorization) {
        if (spent.size() == MAX_SPENT) {
            spent.remove(0);
        }
        spent.add(factorization);
    }

    /** The memory that all factorizations but the large one take, in integers. */
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

    private void remember(SymbolicFactorization factorization) {
        if (factorization.numbers() > LARGE) {
            addSpent(large);
            large = factorization;
            useless = 0;
            return;
        }
        factorizations.add(0, factorization);
        numbers += factorization.numbers();
        while (factorizations.size() > MAX_PLANS || numbers > MAX_NUMBERS) {
            SymbolicFactorization last = factorizations.remove(factorizations.size() - 1);
            numbers -= last.numbers();
            addSpent(last);
        }
    }
}

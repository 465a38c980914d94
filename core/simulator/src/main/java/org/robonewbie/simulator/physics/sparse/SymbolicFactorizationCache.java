package org.robonewbie.simulator.physics.sparse;

import java.util.ArrayList;
import java.util.List;

/**
 * LRU cache of symbolic factorizations, because the same few contact patterns recur.
 *
 * <p>The factorization of a pile of robots is large and rarely reused unless the pile is at rest. Only the most recent large
 * one is kept, and it is released if it has not been used for some time. All smaller ones share a memory limit.
 */
final class SymbolicFactorizationCache {

    private static final int MAX_ENTRIES = 64;
    private static final int MAX_INTS = 1 << 18;
    private static final int LARGE_INTS = 1 << 15;
    private static final int MAX_UNUSED_LOOKUPS = 2_000;
    private static final int MAX_POOLED = 16;

    /** Cached factorizations, most recently used first. */
    private final List<SymbolicFactorization> factorizations = new ArrayList<>();
    /** Evicted factorizations whose arrays can be reused, oldest first. */
    private final List<SymbolicFactorization> pool = new ArrayList<>();

    private CouplingGraph graph = new CouplingGraph();
    private SymbolicFactorization large = new SymbolicFactorization();
    private int unusedLookups;
    private int[] key = {};
    private int memoryInInts;
    private long misses;

    SymbolicFactorization get(List<ConstraintJoint> joints, int bodies) {
        int length = writeKey(joints);
        unusedLookups++;
        if (large.joints() > 0 && unusedLookups > MAX_UNUSED_LOOKUPS) {
            releaseLarge();
        }
        for (int i = 0; i < factorizations.size(); i++) {
            if (factorizations.get(i).matches(key, length)) {
                factorizations.add(0, factorizations.remove(i));
                return factorizations.get(0);
            }
        }
        if (large.matches(key, length)) {
            unusedLookups = 0;
            return large;
        }
        misses++;
        SymbolicFactorization factorization = acquire(joints.size());
        factorization.compute(key, length, bodies, graph);
        store(factorization);
        return factorization;
    }

    long misses() {
        return misses;
    }

    private void releaseLarge() {
        large = new SymbolicFactorization();
        graph = new CouplingGraph();
        pool.clear();
    }

    /** Returns an evicted factorization of about the required size, or a new one. */
    private SymbolicFactorization acquire(int joints) {
        for (int i = pool.size() - 1; i >= 0; i--) {
            if (pool.get(i).hasRoomFor(joints)) {
                return pool.remove(i);
            }
        }
        return new SymbolicFactorization();
    }

    private void recycle(SymbolicFactorization factorization) {
        if (pool.size() == MAX_POOLED) {
            pool.remove(0);
        }
        pool.add(factorization);
    }

    /** Returns the total array length of all factorizations except the large one. */
    int memoryInInts() {
        return memoryInInts;
    }

    private int writeKey(List<ConstraintJoint> joints) {
        int length = CouplingGraph.INTS_PER_JOINT * joints.size();
        if (key.length < length) {
            key = new int[2 * length];
        }
        for (int i = 0; i < joints.size(); i++) {
            ConstraintJoint joint = joints.get(i);
            int at = CouplingGraph.INTS_PER_JOINT * i;
            key[at] = joint.first.islandIndex;
            key[at + 1] = joint.second == null ? CouplingGraph.FIXED : joint.second.islandIndex;
            key[at + 2] = joint.rowCount();
        }
        return length;
    }

    private void store(SymbolicFactorization factorization) {
        if (factorization.memoryInInts() > LARGE_INTS) {
            recycle(large);
            large = factorization;
            unusedLookups = 0;
            return;
        }
        factorizations.add(0, factorization);
        memoryInInts += factorization.memoryInInts();
        while (factorizations.size() > MAX_ENTRIES || memoryInInts > MAX_INTS) {
            SymbolicFactorization last = factorizations.remove(factorizations.size() - 1);
            memoryInInts -= last.memoryInInts();
            recycle(last);
        }
    }
}

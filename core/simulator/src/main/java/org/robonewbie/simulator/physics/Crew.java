package org.robonewbie.simulator.physics;

import java.util.function.IntConsumer;

/**
 * Does work that falls into independent pieces, on as many threads as it has.
 *
 * <p>What comes out must not depend on who does which piece, nor when: pieces write to nothing that another one reads or writes.
 */
public interface Crew {

    /** Does all work on the thread that asks, one piece after the other. */
    Crew ALONE = (pieces, work) -> {
        for (int piece = 0; piece < pieces; piece++) {
            work.accept(piece);
        }
    };

    /**
     * Does each piece once, and returns when all are done. What was written before is seen by all pieces, and what they write is
     * seen afterwards.
     *
     * @param pieces how many there are, at least 0
     * @param work receives the number of a piece, from 0 on
     */
    void divide(int pieces, IntConsumer work);
}

package org.robonewbie.simulator.physics;

import java.util.function.IntConsumer;

/**
 * Executor of independent tasks, on any number of threads.
 *
 * <p>The result must not depend on the order of the tasks or on the threads: a task must not write to anything that
 * another task accesses.
 */
public interface Crew {

    /** Runs all tasks sequentially on the calling thread. */
    Crew ALONE = (count, task) -> {
        for (int index = 0; index < count; index++) {
            task.accept(index);
        }
    };

    /**
     * Runs a task for each index and returns when all are done. Earlier writes by the caller are visible to all tasks,
     * and their writes are visible to the caller afterwards.
     *
     * @param count number of tasks, at least 0
     * @param task receives the index of a task, starting from 0
     */
    void divide(int count, IntConsumer task);
}

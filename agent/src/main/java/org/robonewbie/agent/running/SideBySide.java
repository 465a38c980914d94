package org.robonewbie.agent.running;

import java.util.List;

/** Runs several robots of one program at the same time, each in a thread of its own. */
public final class SideBySide {

    private SideBySide() {}

    /**
     * Runs all tasks and waits for their ends. The first one runs in the current thread.
     *
     * @param tasks at least one
     */
    public static void run(List<Runnable> tasks) {
        List<Thread> others = tasks.stream().skip(1).map(Thread::new).toList();
        others.forEach(Thread::start);
        tasks.get(0).run();
        others.forEach(SideBySide::await);
    }

    private static void await(Thread thread) {
        try {
            thread.join();
        } catch (InterruptedException end) {
            Thread.currentThread().interrupt();
        }
    }
}

package org.robonewbie.pagejvm;

import org.jspecify.annotations.Nullable;

/** Pending result of a call that suspends the program. */
public interface Waiting {

    /** {@return whether the result is available; polled while the program is suspended} */
    boolean isReady();

    /**
     * Advances the world by one cycle. Called repeatedly if compiled code has called the program and therefore must
     * block.
     */
    void hurry();

    /** {@return the result} */
    @Nullable
    Object result();
}

package org.robonewbie.pagejvm;

import org.jspecify.annotations.Nullable;

/** Pending result of a call that suspends the program. */
public interface Waiting {

    /** {@return whether the result is available; polled on each turn} */
    boolean isReady();

    /** Advances the world, for compiled code that has called the program and must block. */
    void hurry();

    /** {@return the result} */
    @Nullable
    Object result();
}

package org.robonewbie.pagejvm;

import org.jspecify.annotations.Nullable;

/** The result of a call that takes longer than a moment: the program stands still until it is there. */
public interface Waiting {

    /** {@return whether the result is there; asked in each turn} */
    boolean isReady();

    /** Lets the world go on, for a caller that cannot come back later: compiled code that has called the program. */
    void hurry();

    /** {@return the result} */
    @Nullable
    Object result();
}

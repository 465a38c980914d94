package org.robonewbie.pagejvm;

/** Thrown when a program uses a feature of Java that the page does not support. */
public final class Missing extends RuntimeException {

    private static final long serialVersionUID = 1;

    /**
     * Creates the exception.
     *
     * @param what the missing feature, without a full stop
     */
    public Missing(String what) {
        super(what + ". The page cannot do this; RoboNewbie on your computer can.");
    }
}

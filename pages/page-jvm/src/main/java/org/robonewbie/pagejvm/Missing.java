package org.robonewbie.pagejvm;

/** Something that Java has and the page has not. */
public final class Missing extends RuntimeException {

    private static final long serialVersionUID = 1;

    /**
     * Names it.
     *
     * @param what what is missing, without a dot at the end
     */
    public Missing(String what) {
        super(what + ". The page cannot do this; RoboNewbie on your computer can.");
    }
}

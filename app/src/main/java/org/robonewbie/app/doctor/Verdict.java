package org.robonewbie.app.doctor;

/** How a check of the installation has ended. */
public enum Verdict {
    /** All is well. */
    WELL("ok"),
    /** It works, but there is something to know. */
    NOTABLE("look"),
    /** It must be mended. */
    BROKEN("FAIL");

    private final String mark;

    Verdict(String mark) {
        this.mark = mark;
    }

    /** {@return the short word that precedes the line} */
    public String mark() {
        return mark;
    }
}

package org.robonewbie.app.doctor;

/** Severity of a finding. */
public enum Verdict {
    /** No problem. */
    WELL("ok"),
    /** Works, but with a restriction. */
    NOTABLE("look"),
    /** Must be fixed. */
    BROKEN("FAIL");

    private final String mark;

    Verdict(String mark) {
        this.mark = mark;
    }

    /** {@return the label at the start of a finding's line} */
    public String mark() {
        return mark;
    }
}

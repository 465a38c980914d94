package org.robonewbie.competition.contest;

/** Outcome of a trial for a team. With any outcome other than {@link #PLAYED}, the team forfeits the trial. */
public enum Ending {
    /** The program ran to the end of the trial. */
    PLAYED("played to the end"),
    /** The program does not compile. */
    NOT_COMPILED("its program does not compile"),
    /** The team's files were refused. */
    REFUSED("its program was rejected"),
    /** The program did not connect a robot. */
    NOT_STARTED("no robot joined"),
    /** The program exited before the end of the trial. */
    STOPPED("its program exited before the end of the trial"),
    /** The program did not respond in time. */
    SILENT("its program did not respond and was removed"),
    /** The program exceeded the memory limit. */
    TOO_MUCH_MEMORY("its program exceeded the memory limit"),
    /** The program exceeded the limit on processor time. */
    TOO_MUCH_TIME("its program exceeded the processor time limit"),
    /** The program exceeded the limit on the number of processes. */
    TOO_MANY_PROCESSES("its program exceeded the process limit"),
    /** The program connected to another team's port. */
    INTRUDED("its program connected to another team's port"),
    /** The team had more robots on the pitch than is allowed in a match or penalty shoot-out. */
    TOO_MANY_ROBOTS("more robots joined than allowed");

    private final String sentence;

    Ending(String sentence) {
        this.sentence = sentence;
    }

    /** {@return the outcome as a sentence without a full stop} */
    public String sentence() {
        return sentence;
    }
}

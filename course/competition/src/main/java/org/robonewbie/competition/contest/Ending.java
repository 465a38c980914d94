package org.robonewbie.competition.contest;

/** How a trial ended for a team. Whatever is not {@link #PLAYED} has lost it the trial. */
public enum Ending {
    /** Its program ran until the trial was over. */
    PLAYED("played to the end"),
    /** Its sources have mistakes. */
    NOT_COMPILED("its program does not compile"),
    /** Its files were refused. */
    REFUSED("its program was refused"),
    /** Its program brought no robot onto the pitch. */
    NOT_STARTED("its program brought no robot onto the pitch"),
    /** Its program ended by itself. */
    STOPPED("its program ended before the trial was over"),
    /** Its program kept the world waiting. */
    SILENT("its program kept the world waiting and was taken out"),
    /** Its program needed too much memory. */
    TOO_MUCH_MEMORY("its program needed more memory than is allowed"),
    /** Its program needed too much processor time. */
    TOO_MUCH_TIME("its program needed more computing time than is allowed"),
    /** Its program started too many processes. */
    TOO_MANY_PROCESSES("its program started more processes than are allowed"),
    /** Its program came through the door of another team. */
    INTRUDED("its program connected to the port of another team"),
    /** It had more robots on the pitch than it may have; that takes a match or a penalty kick. */
    TOO_MANY_ROBOTS("its program brought more robots onto the pitch than are allowed");

    private final String sentence;

    Ending(String sentence) {
        this.sentence = sentence;
    }

    /** {@return the ending as a sentence without full stop} */
    public String sentence() {
        return sentence;
    }
}

package org.robonewbie.agent.cycle;

import org.robonewbie.agent.log.StudentCode;

/** Listener that is notified when a robot program starts and stops running within a cycle. */
public interface CycleWatch {

    /** Ignores all events. */
    CycleWatch NONE = new CycleWatch() {};

    /** Called when the sensors have been read. */
    default void thinkBegins() {}

    /** Called when the answer has been sent; the program may continue to run before it waits for the next message. */
    default void thinkResumes() {}

    /** Called when the answer is complete or the program waits for the next message. */
    default void thinkEnds() {}

    /** {@return the file and line at which the program spent its time in a slow cycle; empty if unknown} */
    default String slowPlace() {
        return StudentCode.place().orElse("");
    }
}

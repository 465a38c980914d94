package org.robonewbie.agent.cycle;

import org.robonewbie.agent.log.StudentCode;

/** An observer of how long the robot's program thinks in each cycle. */
public interface CycleWatch {

    /** Observes nothing. */
    CycleWatch NONE = new CycleWatch() {
        @Override
        public void thinkBegins() {}

        @Override
        public void thinkResumes() {}

        @Override
        public void thinkEnds() {}

        @Override
        public String slowPlace() {
            return StudentCode.place().orElse("");
        }
    };

    /** The sensors have been read. */
    void thinkBegins();

    /** The answer has been sent; the program may do more before it asks for the next message. */
    void thinkResumes();

    /** The answer is complete, or the program asks for the next message. */
    void thinkEnds();

    /** {@return file and line where the program spent its time in a slow cycle; empty if that is not known} */
    String slowPlace();
}

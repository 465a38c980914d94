package org.robonewbie.simulator;

/** Output for the simulator's messages to the user. */
@FunctionalInterface
public interface Console {

    /**
     * Prints a message.
     *
     * @param sentence a complete sentence
     */
    void say(String sentence);

    /** {@return the console that writes to the standard error stream} */
    static Console standard() {
        return sentence -> System.err.println("simulator: " + sentence);
    }

    /** {@return a console that discards everything} */
    static Console silent() {
        return sentence -> {};
    }
}

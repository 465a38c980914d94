package org.robonewbie.simulator;

/** Where the simulator tells people in plain sentences what happens. */
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

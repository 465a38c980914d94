package org.robonewbie.simulator.server;

/** Where the simulator tells people in plain sentences what happens. */
@FunctionalInterface
public interface Console {

    /**
     * Tells one thing.
     *
     * @param sentence a complete sentence
     */
    void say(String sentence);

    /**
     * Gives the console that writes to the standard error stream.
     *
     * @return the console
     */
    static Console standard() {
        return sentence -> System.err.println("simulator: " + sentence);
    }

    /**
     * Gives a console that tells nobody.
     *
     * @return the console
     */
    static Console silent() {
        return sentence -> {};
    }
}

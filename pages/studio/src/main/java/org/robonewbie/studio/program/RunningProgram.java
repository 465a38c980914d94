package org.robonewbie.studio.program;

/** A student's program in a process of its own. Any thread may ask. */
public interface RunningProgram extends AutoCloseable {

    /** {@return the end of what the program has printed} */
    String output();

    /** {@return whether the process has not ended yet} */
    boolean isRunning();

    /** {@return how the process has ended; 0 while it runs} */
    int exitCode();

    /** Ends the process; what it has printed until then can be read afterwards. */
    @Override
    void close();
}

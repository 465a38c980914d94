package org.robonewbie.studio.program;

/** A student's program in its own process. Thread-safe. */
public interface RunningProgram extends AutoCloseable {

    /** {@return the tail of the program's output} */
    String output();

    /** {@return whether the process is alive} */
    boolean isRunning();

    /** {@return exit code of the process; 0 while it runs} */
    int exitCode();

    /** Ends the process; its output remains readable. */
    @Override
    void close();
}

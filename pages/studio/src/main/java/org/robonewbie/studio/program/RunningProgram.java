package org.robonewbie.studio.program;

/** A student's program. Thread-safe. */
public interface RunningProgram extends AutoCloseable {

    /** {@return the tail of the program's output} */
    String output();

    /** {@return whether the program is running} */
    boolean isRunning();

    /** {@return the exit code of its process; 0 while it runs} */
    int exitCode();

    /** Terminates the program; its output remains readable. */
    @Override
    void close();
}

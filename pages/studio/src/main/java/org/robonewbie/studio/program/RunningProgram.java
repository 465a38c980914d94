package org.robonewbie.studio.program;

import org.robonewbie.nao.file.TemporaryFolder;
import org.robonewbie.programs.process.ChildProcess;

/**
 * A student's program in its own process. Thread-safe.
 *
 * @param process the process
 * @param classes its compiled classes, deleted after the process has exited
 */
public record RunningProgram(ChildProcess process, TemporaryFolder classes) implements AutoCloseable {

    /** {@return the tail of the program's output} */
    public String output() {
        return process.output().end();
    }

    /** {@return whether the process is alive} */
    public boolean isRunning() {
        return process.isRunning();
    }

    /** {@return the exit code of the process; 0 while it runs} */
    public int exitCode() {
        return process.exitCode().orElse(0);
    }

    /** Terminates the process; its output remains readable. */
    @Override
    public void close() {
        process.close();
        classes.close();
    }
}

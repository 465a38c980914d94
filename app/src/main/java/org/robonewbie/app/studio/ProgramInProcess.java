package org.robonewbie.app.studio;

import org.robonewbie.nao.file.TemporaryFolder;
import org.robonewbie.programs.process.ChildProcess;
import org.robonewbie.studio.program.RunningProgram;

/**
 * A student's program in its own process.
 *
 * @param process the process
 * @param classes its compiled classes, deleted after the process has exited
 */
record ProgramInProcess(ChildProcess process, TemporaryFolder classes) implements RunningProgram {

    @Override
    public String output() {
        return process.output().end();
    }

    @Override
    public boolean isRunning() {
        return process.isRunning();
    }

    @Override
    public int exitCode() {
        return process.exitCode().orElse(0);
    }

    @Override
    public void close() {
        process.close();
        classes.close();
    }
}

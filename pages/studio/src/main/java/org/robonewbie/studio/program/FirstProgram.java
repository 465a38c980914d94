package org.robonewbie.studio.program;

import org.robonewbie.simulator.embedded.HostProgram;

/**
 * The program that runs when the studio opens.
 *
 * @param path path of its file; for an example, the path of the copy to be created
 * @param example name of the example; empty for one of the user's own programs
 * @param program the program, which ends when a page replaces it
 */
public record FirstProgram(String path, String example, HostProgram program) {

    /** {@return the program; its output goes to the terminal only} */
    RunningProgram running() {
        return new RunningProgram() {
            @Override
            public String output() {
                return "";
            }

            @Override
            public boolean isRunning() {
                return program.isRunning();
            }

            @Override
            public int exitCode() {
                return 0;
            }

            @Override
            public void close() {
                program.end();
            }
        };
    }
}

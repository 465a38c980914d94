package org.robonewbie.programs.process;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.List;
import org.robonewbie.programs.ClassPath;

/** Starts {@link ProgramMain} in a process whose lines count where coverage is measured. */
final class TestProcess {

    private TestProcess() {}

    static ChildProcess start(Path folder, ProgramOutput output, Limits limits, List<String> words) throws IOException {
        List<String> options = ManagementFactory.getRuntimeMXBean().getInputArguments().stream()
                .filter(option -> option.startsWith("-javaagent:"))
                .toList();
        return ChildProcess.start(
                JavaCommand.ofProgram(64, options, ClassPath.ofThisProgram(), words), folder, true, output, limits);
    }
}

package org.robonewbie.programs.process;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class WaitingProcessTest {

    @TempDir
    private Path folder;

    @Test
    void programRunsInTheProcessThatWaits() {
        try (WaitingProcess waiting = new WaitingProcess(folder);
                ChildProcess process = run(waiting, "one", "two words")) {
            process.awaitEnd(60);

            assertThat(process.exitCode()).hasValue(5);
            assertThat(process.output().end()).startsWith("one two words in ");
        }
    }

    private ChildProcess run(WaitingProcess waiting, String... options) {
        waiting.prepare();
        return waiting.start(ChildProcessTest.Fails.class.getName(), folder, List.of(options));
    }
}

package org.robonewbie.programs.process;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

@Timeout(120)
class ChildProcessTest {

    private static final double SECONDS = 60;

    @TempDir
    private Path folder;

    private final BlockingQueue<String> lines = new LinkedBlockingQueue<>();

    /** Prints its arguments and its working directory, and fails. */
    static final class Fails {
        public static void main(String[] args) {
            System.out.println(String.join(" ", args) + " in " + Path.of("").toAbsolutePath());
            System.exit(5);
        }
    }

    /** Takes more memory than it may. */
    static final class EatsMemory {
        public static void main(String[] args) {
            System.out.println(new long[1 << 30].length);
        }
    }

    /** Computes without end. */
    static final class Loops {
        public static void main(String[] args) {
            for (long i = 0; i >= 0; i = (i + 1) % 1_000_000) {
                Thread.interrupted();
            }
        }
    }

    /** Prints the process number of a process that it has started, and waits for it. */
    static final class HasAChild {
        public static void main(String[] args) throws Exception {
            Process child = new ProcessBuilder("sleep", "100000").start();
            System.out.println(child.pid());
            child.waitFor();
        }
    }

    @Test
    void outputAndExitCodeAreReported() throws IOException {
        try (ChildProcess process = start(Fails.class, Limits.UNTIMED, "a", "b")) {
            boolean ended = process.awaitEnd(SECONDS);

            assertThat(ended).isTrue();
            assertThat(process.exitCode()).hasValue(5);
            assertThat(process.excess()).isEmpty();
            assertThat(lines).containsExactly("a b in " + folder.toRealPath());
            assertThat(process.call("too late")).isFalse();
        }
    }

    @Test
    void memoryIsLimited() throws IOException {
        try (ChildProcess process = start(EatsMemory.class, Limits.UNTIMED)) {
            process.awaitEnd(SECONDS);

            assertThat(process.excess()).contains(ChildProcess.Excess.MEMORY);
        }
    }

    @Tag("slow")
    @Test
    void processorTimeIsLimited() throws IOException {
        Limits limits = new Limits(64, 0.5, SECONDS, SECONDS, SECONDS);

        try (ChildProcess process = start(Loops.class, limits)) {
            process.awaitEnd(SECONDS);

            assertThat(process.excess()).contains(ChildProcess.Excess.PROCESSOR_TIME);
            assertThat(process.exitCode()).isEmpty();
        }
    }

    @DisabledOnOs(OS.WINDOWS)
    @Test
    void descendantsEndWithTheProcess() throws Exception {
        ProcessHandle child;
        try (ChildProcess process = start(HasAChild.class, Limits.UNTIMED)) {
            child = ProcessHandle.of(Long.parseLong(lines.take())).orElseThrow();
            assertThat(process.isRunning()).isTrue();
        }

        child.onExit().join();

        assertThat(child.isAlive()).isFalse();
    }

    private ChildProcess start(Class<?> program, Limits limits, String... arguments) throws IOException {
        List<String> words = new ArrayList<>(List.of(ProgramMain.CLASS, program.getName()));
        words.addAll(List.of(arguments));
        return TestProcess.start(folder, ProgramOutput.of(lines::add, answer -> {}), limits, words);
    }
}

package org.robonewbie.examples;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** A program in a JVM of its own, for what only a whole program shows: its exit code and its last words. */
final class ChildProgram implements AutoCloseable {

    private static final int PATIENCE_SECONDS = 120;

    private final Process process;
    private final BufferedReader reader;
    private final List<String> lines = new ArrayList<>();

    ChildProgram(Path folder, Class<?> program, String... args) throws IOException {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Xmx300m",
                "-cp",
                System.getProperty("java.class.path"),
                program.getName()));
        command.addAll(List.of(args));
        process = new ProcessBuilder(command)
                .directory(folder.toFile())
                .redirectErrorStream(true)
                .start();
        reader = process.inputReader();
    }

    /** Reads on until a line contains a text. */
    void awaitLine(String text) throws IOException {
        String line = reader.readLine();
        while (line != null) {
            lines.add(line);
            if (line.contains(text)) {
                return;
            }
            line = reader.readLine();
        }
        throw new IOException("The program ended without \"" + text + "\": " + lines);
    }

    /** Whether this operating system can ask a program to end; Windows can only kill it. */
    boolean canBeInterrupted() {
        return process.supportsNormalTermination();
    }

    /** Asks the program to end, as Ctrl-C does, and leaves its output open. */
    void interrupt() {
        process.toHandle().destroy();
    }

    /** Waits for the end and gives the exit code. */
    int exitCode() throws IOException, InterruptedException {
        String line = reader.readLine();
        while (line != null) {
            lines.add(line);
            line = reader.readLine();
        }
        if (!process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
            throw new IOException("The program does not end: " + lines);
        }
        return process.exitValue();
    }

    /** All lines that were printed so far. */
    List<String> lines() {
        return lines;
    }

    @Override
    public void close() {
        process.destroyForcibly();
    }
}

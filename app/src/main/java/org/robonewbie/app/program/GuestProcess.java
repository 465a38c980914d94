package org.robonewbie.app.program;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.robonewbie.competition.team.ProcessTree;
import org.robonewbie.exercises.Exercise;

/** A student's program in a process of its own, which comes to a trial through a port as any agent does. */
public final class GuestProcess implements AutoCloseable {

    private static final int MOST_CHARACTERS = 4000;

    private static final long MILLISECONDS_FOR_LAST_WORDS = 1000;

    private final ProcessTree processes;
    private final Process process;
    private final Thread reader;
    private final StringBuilder output = new StringBuilder();

    private GuestProcess(ProcessTree processes) {
        this.processes = processes;
        process = processes.process();
        reader = new Thread(() -> keep(process.getInputStream()), "output-of-program");
        reader.setDaemon(true);
    }

    /**
     * Starts a program.
     *
     * @param exercise what it is to solve
     * @param program class or Java file
     * @param port where its trial waits for it
     * @param folder its working directory
     * @return the running process
     */
    public static GuestProcess start(Exercise exercise, String program, int port, Path folder) {
        List<String> command = StudentJava.grade(
                List.of(StudentJava.QUICK_START),
                List.of(exercise.name(), program, StudentJava.AT_DOOR, Integer.toString(port)));
        GuestProcess guest = start(command, folder);
        guest.tell("");
        return guest;
    }

    /**
     * Starts a process that waits for a word.
     *
     * @param command program and arguments
     * @param folder its working directory
     * @return the running process
     */
    static GuestProcess start(List<String> command, Path folder) {
        try {
            ProcessBuilder builder =
                    new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true);
            GuestProcess guest = new GuestProcess(ProcessTree.start(builder, Optional.empty()));
            guest.reader.start();
            return guest;
        } catch (IOException unstartable) {
            throw new UncheckedIOException("The program cannot be started: " + unstartable.getMessage(), unstartable);
        }
    }

    /** Says something to the program and nothing more: one that reads from the terminal does not wait for anybody. */
    void tell(String text) {
        try (OutputStream input = process.getOutputStream()) {
            input.write(text.getBytes(StandardCharsets.UTF_8));
        } catch (IOException ended) {
            append("");
        }
    }

    /** Keeps the end of what the program prints. */
    private void keep(InputStream stream) {
        byte[] bytes = new byte[MOST_CHARACTERS];
        try {
            for (int count = stream.read(bytes); count >= 0; count = stream.read(bytes)) {
                append(new String(bytes, 0, count, Charset.defaultCharset()));
            }
        } catch (IOException end) {
            append("");
        }
    }

    private synchronized void append(String text) {
        output.append(text);
        output.delete(0, Math.max(0, output.length() - MOST_CHARACTERS));
    }

    /** {@return the end of what the program has printed} */
    public synchronized String output() {
        return output.toString();
    }

    /** {@return whether the process has not ended yet} */
    public boolean isRunning() {
        return process.isAlive();
    }

    /** {@return how the process has ended; 0 while it runs} */
    public int exitCode() {
        return process.isAlive() ? 0 : process.exitValue();
    }

    /** Ends the process with all that it has started; what it has printed until then can be read afterwards. */
    @Override
    public void close() {
        processes.close();
        try {
            reader.join(MILLISECONDS_FOR_LAST_WORDS);
        } catch (InterruptedException isOver) {
            Thread.currentThread().interrupt();
        }
    }
}

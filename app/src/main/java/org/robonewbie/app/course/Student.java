package org.robonewbie.app.course;

import java.io.IOException;
import java.io.OutputStream;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.robonewbie.app.program.StudentJava;
import org.robonewbie.competition.team.ProcessTree;
import org.robonewbie.exercises.Performance;
import org.robonewbie.exercises.Score;
import org.robonewbie.nao.file.RegularFile;
import org.robonewbie.trial.guest.AbsentProgramException;

/**
 * The process of a student's program, as its judge sees it.
 *
 * @param processes the process, with all that it starts
 * @param calls where it hears what robots are wanted
 * @param complaints folder in which it says why robots have given up
 */
record Student(ProcessTree processes, OutputStream calls, Path complaints) {

    private static final int OUT_OF_MEMORY = 3;
    private static final int MILLISECONDS_TO_END = 500;
    private static final int MAX_BYTES = 4000;

    Process process() {
        return processes.process();
    }

    /** Whether a connection to the door of a trial may pass: programs that are graded at the same time have doors of their own. */
    boolean isWelcome(int door, InetSocketAddress guest) {
        return !ProcessTree.knowsConnections() || processes.holds(guest.getPort(), door);
    }

    /** Whether the program could be compiled and loaded. */
    boolean isReady() {
        return Files.exists(complaints.resolve(RobotsOnCall.READY));
    }

    synchronized void call(RobotsOnCall.Call call) {
        try {
            calls.write(call.line().getBytes(StandardCharsets.UTF_8));
            calls.flush();
        } catch (IOException gone) {
            throw new AbsentProgramException("The program ended before it asked for a robot.", gone);
        }
    }

    /** Why the robots of a trial gave up: what they say themselves, or that the process has ended. */
    Optional<Score> reason(int port) {
        return complaint(Integer.toString(port))
                .or(() -> process().isAlive() ? Optional.empty() : Optional.of(ending()));
    }

    /** What makes the program slow, if anything does. */
    Optional<Score> slowness() {
        return complaint(RobotsOnCall.SLOW);
    }

    /** The program could have put anything in place of the file. */
    private Optional<Score> complaint(String file) {
        try {
            byte[] told = RegularFile.read(complaints.resolve(file), MAX_BYTES);
            String[] lines = new String(told, StandardCharsets.UTF_8).split("\n", 2);
            return Optional.of(Score.failed(0, lines[0], lines.length > 1 ? lines[1] : Performance.MEND));
        } catch (IOException none) {
            return Optional.empty();
        }
    }

    private Score ending() {
        int code = exitCode();
        return code == OUT_OF_MEMORY
                ? Score.failed(0, "The program took all memory (" + StudentJava.MEGABYTES + " MB).", Performance.MEND)
                : Performance.ofExit(code);
    }

    /** Waits a moment for the end, since connections end before their process does. */
    int exitCode() {
        try {
            return process().waitFor(MILLISECONDS_TO_END, TimeUnit.MILLISECONDS)
                    ? process().exitValue()
                    : 1;
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            return 1;
        }
    }

    /** Ends the program with all that it has started. */
    void end() {
        processes.close();
    }
}

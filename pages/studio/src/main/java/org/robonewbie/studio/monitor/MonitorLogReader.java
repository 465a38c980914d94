package org.robonewbie.studio.monitor;

import java.io.EOFException;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.monitor.Foul;
import org.robonewbie.protocol.monitor.MonitoredGame;
import org.robonewbie.protocol.monitor.MonitoredWorld;
import org.robonewbie.protocol.monitor.RsmpWorld;
import org.robonewbie.simulator.file.RecordingFile;

/**
 * Converts a log of monitor messages to a recording. Reads {@code sparkmonitor.log} from rcssserver3d and from RoboNewbie's
 * simulator, with one message per line, RoboViz logs, and the log that RCSSServerMJ writes with {@code --logfile}. Logs may be
 * compressed with gzip. Cycles between two messages are interpolated, because SimSpark's logs contain only five states per second and
 * those of RCSSServerMJ 25.
 */
public final class MonitorLogReader {

    /** How much of a log is searched for the first complete scene, after decompression. */
    private static final long MAX_SEARCHED_BYTES = 1L << 26;

    private final Path log;
    private final Path recording;
    private final MonitoredWorld world = new MonitoredWorld();
    private final MonitorClock clock = new MonitorClock(() -> 0);
    private final MessageBuffer line = new MessageBuffer();
    private final MessageBuffer message = new MessageBuffer();
    private Optional<MonitorRecorder> recorder = Optional.empty();
    private MonitoredGame game = MonitoredGame.UNKNOWN;
    private long messages;
    private long refused;
    private Optional<String> firstProblem = Optional.empty();

    private MonitorLogReader(Path log, Path recording) {
        this.log = log;
        this.recording = recording;
    }

    /**
     * Converts a log.
     *
     * @param log the log
     * @param recording the recording to write
     * @return what was not understood, as a sentence; empty if everything was
     * @throws IOException if the log cannot be read or contains no complete scene
     */
    public static Optional<String> convert(Path log, Path recording) throws IOException {
        LogConversion conversion = LogConversion.start(log, recording);
        conversion.awaitEnd();
        return conversion.remark();
    }

    /** Creates a reader that has not read anything. */
    static MonitorLogReader of(Path log, Path recording) {
        return new MonitorLogReader(log, recording);
    }

    /** Reads up to the first complete scene, with which the recording starts. */
    void begin(LogLines lines) throws IOException {
        while (recorder.isEmpty() && lines.bytes() < MAX_SEARCHED_BYTES && next(lines)) {
            take(lines.number());
        }
        if (recorder.isEmpty()) {
            throw new IOException("\"" + log + "\" "
                    + firstProblem
                            .map(problem -> "is a log of RCSSServerMJ that cannot be read. " + problem)
                            .orElse("is not a server log: it contains no complete scene."));
        }
    }

    /** Reads the rest and completes the recording. Returns what was not understood. */
    Optional<String> finish(LogLines lines) throws IOException {
        try {
            while (next(lines)) {
                take(lines.number());
            }
        } finally {
            recorder.ifPresent(MonitorRecorder::close);
        }
        return firstProblem.map(problem -> "Messages in \"" + log + "\" that were not understood: " + refused + " of "
                + messages + ". " + problem);
    }

    /** Reads the next line. A log of RCSSServerMJ that is cut off ends where it is cut; the server may have been killed. */
    private boolean next(LogLines lines) throws IOException {
        try {
            return lines.next(line);
        } catch (EOFException cut) {
            if (recorder.isPresent() && world.rsmp().isPresent()) {
                note(lines.number() + 1, "the compressed file ends in the middle");
                return false;
            }
            throw cut;
        }
    }

    /** Reads a line. In RoboViz logs, a list of numbers for the drawings precedes the message, which starts at the first "((". */
    private void take(long number) throws IOException {
        int start = startOfMessage();
        if (start < 0) {
            return;
        }
        message.clear();
        message.resize(line.length() - start);
        System.arraycopy(line.bytes(), start, message.bytes(), 0, message.length());
        messages++;
        boolean current = world.read(message);
        noteProblem(number);
        if (!current) {
            return;
        }
        clock.tick(world);
        if (recorder.isEmpty()) {
            recorder = Optional.of(MonitorRecorder.open(RecordingFile.open(recording, problem -> {}), world));
        }
        noteEvents(recorder.get());
        recorder.get().write(MonitorSnapshots.of(world, clock.cycle(), 1, false));
    }

    private int startOfMessage() {
        byte[] bytes = line.bytes();
        for (int i = 0; i + 1 < line.length(); i++) {
            if (bytes[i] == '(' && bytes[i + 1] == '(') {
                return i;
            }
        }
        return -1;
    }

    private void noteProblem(long number) {
        world.rsmp().flatMap(RsmpWorld::problem).ifPresent(problem -> note(number, problem.reason()));
    }

    private void note(long number, String reason) {
        refused++;
        if (firstProblem.isEmpty()) {
            firstProblem = Optional.of("Line " + number + ": " + reason + ".");
        }
    }

    private void noteEvents(MonitorRecorder target) {
        MonitorEvents.between(game, world.gameState()).forEach(target::happened);
        game = world.gameState();
        for (Foul foul : world.newFouls()) {
            target.happened(MonitorEvents.of(foul));
        }
    }
}

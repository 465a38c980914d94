package org.robonewbie.studio.monitor;

import java.io.BufferedInputStream;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.zip.GZIPInputStream;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.monitor.Foul;
import org.robonewbie.protocol.monitor.MonitoredGame;
import org.robonewbie.protocol.monitor.MonitoredWorld;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.file.RecordingFile;
import org.robonewbie.simulator.recording.RecordingWriter;
import org.robonewbie.simulator.soccer.MatchEvent;

/**
 * Converts a log of monitor messages to a recording. Reads {@code sparkmonitor.log} from rcssserver3d and from RoboNewbie's
 * simulator, with one message per line, and RoboViz logs. Logs may be compressed with gzip. Cycles between two messages are
 * interpolated, because such logs contain only five states per second.
 */
public final class MonitorLogReader {

    private static final int GZIP_MARK = 0x1f;
    private static final int MAX_INTERPOLATED_CYCLES = 15;

    private final MonitoredWorld world = new MonitoredWorld();
    private final MonitorClock clock = new MonitorClock(() -> 0);
    private final MessageBuffer message = new MessageBuffer();
    private final List<String> events = new ArrayList<>();
    private Optional<RecordingWriter> recording = Optional.empty();
    private Optional<WorldSnapshot> last = Optional.empty();
    private MonitoredGame game = MonitoredGame.UNKNOWN;

    private MonitorLogReader() {}

    /**
     * Converts a log.
     *
     * @param log the log
     * @param recording the recording to write
     * @throws IOException if the log cannot be read or contains no complete scene
     */
    public static void convert(Path log, Path recording) throws IOException {
        MonitorLogReader reader = new MonitorLogReader();
        try (BufferedReader lines = open(log)) {
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                reader.take(line, recording);
            }
        } catch (UncheckedIOException damaged) {
            throw new IOException("\"" + log + "\" cannot be read completely: " + damaged.getMessage(), damaged);
        } finally {
            reader.recording.ifPresent(RecordingWriter::close);
        }
        if (reader.recording.isEmpty()) {
            throw new IOException("\"" + log + "\" is not a SimSpark server log: it contains no complete scene.");
        }
    }

    private static BufferedReader open(Path log) throws IOException {
        InputStream raw = new BufferedInputStream(Files.newInputStream(log));
        raw.mark(1);
        boolean packed = raw.read() == GZIP_MARK;
        raw.reset();
        InputStream plain = packed ? new GZIPInputStream(raw) : raw;
        return new BufferedReader(new InputStreamReader(plain, StandardCharsets.ISO_8859_1));
    }

    /** Reads a line. In RoboViz logs, a list of numbers for the drawings precedes the message, which starts at the first "((". */
    private void take(String line, Path file) throws IOException {
        int start = line.indexOf("((");
        if (start < 0) {
            return;
        }
        message.clear();
        message.append(line.substring(start));
        if (!world.read(message)) {
            return;
        }
        clock.tick(world.gameState());
        noteEvents();
        if (recording.isEmpty()) {
            recording = Optional.of(RecordingWriter.open(RecordingFile.open(file, problem -> {}), header()));
        }
        write(recording.get(), MonitorSnapshots.of(world, clock.cycle(), 1, false));
    }

    private void write(RecordingWriter target, WorldSnapshot now) {
        if (last.isPresent() && now.cycle() == last.get().cycle()) {
            return;
        }
        last.ifPresent(before -> {
            long gap = now.cycle() - before.cycle();
            for (long i = 1; i < gap && gap <= MAX_INTERPOLATED_CYCLES; i++) {
                target.write(Blend.of(before, now, (double) i / gap), List.of());
            }
        });
        target.write(now, events);
        events.clear();
        last = Optional.of(now);
    }

    private void noteEvents() {
        MonitorEvents.between(game, world.gameState()).stream()
                .map(MatchEvent::text)
                .forEach(events::add);
        game = world.gameState();
        for (Foul foul : world.newFouls()) {
            events.add(MonitorEvents.of(foul).text());
        }
    }

    private List<String> header() {
        SoccerField field = MonitorSnapshots.field(world.environment());
        return List.of(
                "FieldLength=" + field.length(),
                "FieldWidth=" + field.width(),
                "GoalWidth=" + field.goalWidth(),
                "GoalDepth=" + field.goalDepth(),
                "GoalHeight=" + field.goalHeight(),
                "PenaltyLength=" + field.penaltyLength(),
                "PenaltyWidth=" + field.penaltyWidth(),
                "FreeKickDistance=" + field.centreCircleRadius());
    }
}

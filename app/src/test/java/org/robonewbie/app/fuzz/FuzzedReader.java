package org.robonewbie.app.fuzz;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.zip.GZIPOutputStream;
import org.robonewbie.agent.PolicyPlayer;
import org.robonewbie.agent.policy.PolicyText;
import org.robonewbie.agent.running.Surroundings;
import org.robonewbie.competition.team.TeamList;
import org.robonewbie.learning.series.ExperimentPlan;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.MotionFormatException;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.protocol.effector.EffectorMessageReader;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.monitor.MonitoredWorld;
import org.robonewbie.protocol.monitor.RsmpWorld;
import org.robonewbie.protocol.order.TrainerOrderReader;
import org.robonewbie.protocol.perceptor.PerceptorMessageReader;
import org.robonewbie.protocol.telemetry.TelemetryLine;
import org.robonewbie.simulator.recording.RecordingReader;
import org.robonewbie.simulator.state.WorldState;
import org.robonewbie.studio.monitor.MonitorLogReader;

/**
 * The readers of bytes that come from elsewhere. Whatever the bytes are, a reader understands them or says in its own kind of
 * exception why not. {@code .ci/fuzz} searches for bytes with which one does something else; what was found is in the resources
 * of this package.
 */
enum FuzzedReader {
    /** What a server tells an agent. */
    PERCEPTORS(bytes -> new PerceptorMessageReader().read(message(bytes))),
    /** What an agent tells the server. */
    EFFECTORS(bytes -> new EffectorMessageReader().read(message(bytes), command -> {}, problem -> {})),
    /** What trainers order. */
    TRAINER(bytes -> new TrainerOrderReader().read(message(bytes))),
    /** What a server tells a monitor: messages, one in each line. */
    MONITOR(FuzzedReader::readMonitor),
    /** What RCSSServerMJ tells a monitor: messages, one in each line. */
    RSMP(FuzzedReader::readRsmp),
    /** What robots of other processes think. */
    TELEMETRY(bytes -> TelemetryLine.read(text(bytes))),
    /** Files of motions. */
    MOTION(FuzzedReader::readMotion),
    /** Recordings as they lie on the disk. */
    RECORDING(FuzzedReader::readRecording),
    /** What is inside of the compressed recordings. */
    UNPACKED_RECORDING(bytes -> readRecording(packed(bytes))),
    /** Logs of SimSpark's monitor. */
    MONITOR_LOG(FuzzedReader::readMonitorLog),
    /** Saved worlds. */
    STATE(WorldState::ofBytes),
    /** Plans of experiments. */
    PLAN(bytes -> inFile(bytes, ExperimentPlan::read)),
    /** Properties beside a program. */
    PROPERTIES(bytes -> inFile(bytes, file -> Surroundings.properties(file.toString()))),
    /** Learned policies. */
    POLICY(bytes -> new PolicyPlayer(PolicyText.parse(text(bytes)))),
    /** Lists of teams. */
    TEAMS(bytes -> TeamList.parse(text(bytes).lines().toList()));

    @SuppressWarnings("ImmutableEnumChecker") // each is a function without state
    private final Reading reading;

    FuzzedReader(Reading reading) {
        this.reading = reading;
    }

    /** Reads bytes. */
    @FunctionalInterface
    private interface Reading {
        void of(byte[] bytes) throws IOException;
    }

    /** Reads a file. */
    @FunctionalInterface
    private interface FileReading {
        void of(Path file) throws IOException;
    }

    /** The reader with a name such as {@code monitor-log}. */
    static FuzzedReader named(String name) {
        return valueOf(name.toUpperCase(Locale.ROOT).replace('-', '_'));
    }

    /** Its name in lower case with hyphens. */
    String label() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** Reads; what the reader promises to throw is well, anything else a mistake. */
    void read(byte[] bytes) {
        try {
            reading.of(bytes);
        } catch (IOException | MotionFormatException | CalledWronglyException refused) {
            requireReason(refused);
        } catch (IllegalArgumentException refused) {
            if (this != STATE && this != PLAN && this != POLICY) {
                throw refused;
            }
            requireReason(refused);
        }
    }

    private static void requireReason(Exception refused) {
        if (refused.getMessage() == null || refused.getMessage().isBlank()) {
            throw new AssertionError("refused without a reason", refused);
        }
    }

    private static void readMonitor(byte[] bytes) {
        MonitoredWorld world = new MonitoredWorld();
        for (String line : text(bytes).lines().toList()) {
            world.read(message(line.getBytes(StandardCharsets.ISO_8859_1)));
        }
    }

    private static void readRsmp(byte[] bytes) {
        RsmpWorld world = new RsmpWorld();
        for (String line : text(bytes).lines().toList()) {
            world.read(message(line.getBytes(StandardCharsets.ISO_8859_1)));
            world.gameState();
            world.ball();
            world.robots();
        }
    }

    private static void readMotion(byte[] bytes) {
        MotionFile motion = MotionFile.parse("fuzzed", bytes);
        motion.errors();
        motion.warnings();
        motion.motion();
    }

    private static void readRecording(byte[] bytes) throws IOException {
        try (RecordingReader recording = RecordingReader.of(new ByteArrayInputStream(bytes), "\"fuzzed\"")) {
            int cycles = 0;
            while (recording.next().isPresent() && cycles < 1000) {
                cycles++;
            }
        }
    }

    private static void readMonitorLog(byte[] bytes) throws IOException {
        Path recording = Files.createTempFile("fuzz", ".rec");
        try {
            inFile(bytes, log -> MonitorLogReader.convert(log, recording));
        } finally {
            Files.deleteIfExists(recording);
        }
    }

    private static void inFile(byte[] bytes, FileReading reading) throws IOException {
        Path file = Files.createTempFile("fuzz", ".txt");
        try {
            reading.of(Files.write(file, bytes));
        } finally {
            Files.deleteIfExists(file);
        }
    }

    private static byte[] packed(byte[] bytes) throws IOException {
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (GZIPOutputStream out = new GZIPOutputStream(packed)) {
            out.write(bytes);
        }
        return packed.toByteArray();
    }

    private static String text(byte[] bytes) {
        return new String(bytes, StandardCharsets.ISO_8859_1);
    }

    private static MessageBuffer message(byte[] bytes) {
        MessageBuffer message = new MessageBuffer();
        message.set(bytes);
        return message;
    }
}

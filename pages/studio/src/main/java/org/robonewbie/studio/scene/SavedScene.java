package org.robonewbie.studio.scene;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.recording.DamagedRecordingException;
import org.robonewbie.simulator.recording.RecordedCycle;
import org.robonewbie.simulator.recording.RecordingReader;
import org.robonewbie.simulator.recording.RecordingTarget;
import org.robonewbie.simulator.recording.RecordingWriter;
import org.robonewbie.simulator.state.WorldState;

/**
 * A scene as bytes: a recording of one cycle, which any recording viewer can show, and the exact state.
 *
 * @param recording the uncompressed recording
 * @param exact the exact state; empty if it was not saved
 */
@SuppressWarnings("ArrayRecordComponent")
public record SavedScene(byte[] recording, byte[] exact) {

    private static final int FRAMES_FOR_VELOCITY = 2;

    static SavedScene of(SoccerField field, WorldSnapshot state, Optional<WorldState> exact) {
        Memory memory = new Memory();
        List<String> header = List.of("FieldLength=" + field.length(), "FieldWidth=" + field.width());
        try (RecordingWriter recording = RecordingWriter.open(memory, header)) {
            recording.write(state, List.of());
        }
        return new SavedScene(
                memory.content.toByteArray(), exact.map(WorldState::toBytes).orElse(new byte[0]));
    }

    private static final class Memory implements RecordingTarget {

        private final ByteArrayOutputStream content = new ByteArrayOutputStream();

        @Override
        public void write(byte[] bytes, int length) {
            content.write(bytes, 0, length);
        }

        @Override
        public void flush() {
            // The bytes are already in memory.
        }

        @Override
        public void close() {
            // The contents remain readable.
        }
    }

    /**
     * Reads a scene in the format of {@link #toBytes}.
     *
     * @param bytes the bytes
     * @return the scene; damaged if the bytes are damaged
     */
    public static SavedScene of(byte[] bytes) {
        try {
            StateReader in = new StateReader(bytes);
            return new SavedScene(in.getBytes(), in.getBytes());
        } catch (IllegalArgumentException damaged) {
            return new SavedScene(bytes, new byte[0]);
        }
    }

    /** {@return the recording and the exact state, in the format that {@link #of} reads} */
    public byte[] toBytes() {
        StateWriter out = new StateWriter();
        out.putBytes(recording, recording.length);
        out.putBytes(exact, exact.length);
        return out.toBytes();
    }

    /** Returns the checkpoint; empty if the scene is damaged. */
    Optional<Checkpoint> checkpoint() throws IOException {
        try {
            return moment(RecordingReader.ofUnpacked(new ByteArrayInputStream(recording), "This"), 0)
                    .map(moment -> new Checkpoint(moment.before(), moment.state(), exactState()));
        } catch (DamagedRecordingException damaged) {
            return Optional.empty();
        }
    }

    /**
     * Returns the exact state. If it is missing or has a different version, the scene can still be restored approximately.
     */
    private Optional<WorldState> exactState() {
        try {
            return exact.length == 0 ? Optional.empty() : Optional.of(WorldState.ofBytes(exact));
        } catch (IllegalArgumentException ofAnotherVersion) {
            return Optional.empty();
        }
    }

    /** Reads a cycle of a recording; empty if there is no such cycle. */
    static Optional<Checkpoint> moment(RecordingReader reader, long index) throws IOException {
        Optional<WorldSnapshot> before = Optional.empty();
        for (long i = 0; i <= index; i++) {
            Optional<WorldSnapshot> state = reader.next().map(RecordedCycle::snapshot);
            if (state.isEmpty()) {
                return Optional.empty();
            }
            if (i == Math.max(0, index - FRAMES_FOR_VELOCITY)) {
                before = state;
            }
            if (i == index) {
                return Optional.of(new Checkpoint(before.orElse(state.get()), state.get(), Optional.empty()));
            }
        }
        return Optional.empty();
    }
}

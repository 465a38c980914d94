package org.robonewbie.studio.scene;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.recording.RecordedCycle;
import org.robonewbie.simulator.recording.RecordingReader;
import org.robonewbie.simulator.recording.RecordingTarget;
import org.robonewbie.simulator.recording.RecordingWriter;

/** Conversion between scenes and recordings: a scene is a recording of one cycle, and each cycle of a recording is a scene. */
final class SceneRecording {

    private static final int FRAMES_FOR_VELOCITY = 2;

    private SceneRecording() {}

    static void write(RecordingTarget target, SoccerField field, WorldSnapshot state) {
        List<String> header = List.of("FieldLength=" + field.length(), "FieldWidth=" + field.width());
        try (RecordingWriter recording = RecordingWriter.open(target, header)) {
            recording.write(state, List.of());
        }
    }

    /** Returns the bytes of an uncompressed recording. */
    static byte[] toBytes(SoccerField field, WorldSnapshot state) {
        Memory recording = new Memory();
        write(recording, field, state);
        return recording.content.toByteArray();
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

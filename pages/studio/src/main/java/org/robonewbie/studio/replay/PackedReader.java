package org.robonewbie.studio.replay;

import com.google.gson.JsonObject;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;
import org.robonewbie.simulator.recording.RecordingState;

/**
 * Incremental reader of a compressed recording that collects random-access points. The file may grow between calls.
 *
 * <p>Random-access points lie where the simulator has flushed the file: the compressed bytes {@code 00 00 FF FF} end a
 * block there (RFC 1951, an empty stored block), so the following block starts at a byte boundary.
 */
final class PackedReader {

    private static final int CHUNK_BYTES = 1 << 16;
    private static final int MAX_OUTPUT_BYTES = 1 << 16;
    private static final int BYTES_BETWEEN_POINTS = 1 << 18;
    private static final int MARK = 0x0000FFFF;

    private final RunWatch watch = new RunWatch();
    private final UnpackedWindow window = new UnpackedWindow();
    private final Inflater inflater = new Inflater(true);
    private final byte[] output = new byte[MAX_OUTPUT_BYTES];
    private final List<EntryPoint> points = new ArrayList<>();
    private long read;
    private boolean damaged;
    private int lastFour = -1;

    /**
     * Continues reading.
     *
     * @param file the recording
     * @param untilNanos deadline in terms of {@link System#nanoTime}
     * @return whether the end of the file was reached
     */
    boolean readOn(Path file, long untilNanos) throws IOException {
        try (SeekableByteChannel channel = Files.newByteChannel(file)) {
            channel.position(read);
            ByteBuffer chunk = ByteBuffer.allocate(CHUNK_BYTES);
            while (!damaged && channel.read(chunk.clear()) > 0) {
                int from = read > 0 ? 0 : begin(chunk);
                if (points.isEmpty()) {
                    return true;
                }
                take(chunk.array(), from, chunk.position());
                if (System.nanoTime() > untilNanos) {
                    return channel.position() == channel.size();
                }
            }
        } catch (DataFormatException endOfWhatIsGood) {
            damaged = true;
        } catch (IllegalArgumentException noRecordingOrDamaged) {
            if (watch.count() == 0) {
                throw noRecordingOrDamaged;
            }
            damaged = true;
        }
        return true;
    }

    /** Adds the first entry point and returns the offset of the compressed bytes. */
    private int begin(ByteBuffer chunk) throws IOException {
        byte[] head = new byte[chunk.position()];
        chunk.duplicate().flip().get(head);
        int length = GzipHeader.length(head, head.length);
        if (length > 0) {
            points.add(EntryPoint.of(length, 0, 0, new EntryPoint.Known(new byte[0], new byte[0])));
        }
        return length;
    }

    private void take(byte[] bytes, int begin, int count) throws DataFormatException, IOException {
        int from = begin;
        for (int i = begin; i < count; i++) {
            lastFour = (lastFour << 8) | (bytes[i] & 0xFF);
            if (lastFour == MARK) {
                unpack(bytes, from, i + 1);
                from = i + 1;
                pointAt(read + from);
            }
        }
        unpack(bytes, from, count);
        read += count;
    }

    private void unpack(byte[] bytes, int from, int end) throws DataFormatException {
        inflater.setInput(bytes, from, end - from);
        for (int length = inflater.inflate(output); length > 0; length = inflater.inflate(output)) {
            window.add(output, length);
            watch.push(output, length);
        }
    }

    private void pointAt(long packedAt) throws IOException {
        long last = points.isEmpty() ? 0 : points.get(points.size() - 1).unpackedAt();
        RecordingState state = watch.state();
        if (state.isBetweenCycles() && inflater.needsInput() && window.written() - last >= BYTES_BETWEEN_POINTS) {
            EntryPoint.Known known = new EntryPoint.Known(state.toRecords(), window.content());
            points.add(EntryPoint.of(packedAt, window.written(), watch.count(), known));
        }
    }

    /** {@return the number of bytes that have been read from the file so far} */
    long read() {
        return read;
    }

    JsonObject summary() {
        return watch.summary();
    }

    List<EntryPoint> points() {
        return List.copyOf(points);
    }

    void close() {
        inflater.end();
    }
}

package org.robonewbie.studio.replay;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SeekableByteChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.zip.CRC32;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.simulator.file.RecordingGroup;

/**
 * Index of a recording, which lets a page start reading at any cycle. Built once by reading the whole recording, and stored
 * as {@code NAME.index} next to large recordings. The index of a recording in progress grows with it. The recording itself
 * is never changed.
 */
final class RecordingIndex {

    private static final String MAGIC = "RoboNewbie index 1";
    private static final long WORTH_A_FILE_BYTES = 1_000_000;
    private static final int FINGERPRINT_BYTES = 4096;
    private static final int MAX_PIECE_BYTES = 4_000_000;
    private static final int BUFFER_BYTES = 1 << 16;

    private final Optional<PackedReader> reader;
    private JsonObject summary;
    private List<EntryPoint> points;
    private byte[] beginning = {};
    private long bytes;
    private boolean whole;

    private RecordingIndex(Optional<PackedReader> reader, JsonObject summary, List<EntryPoint> points) {
        this.reader = reader;
        this.summary = summary;
        this.points = points;
        this.whole = reader.isEmpty();
    }

    /**
     * Opens the index of a recording: the stored one if it matches, otherwise an empty one to be filled by {@link
     * #readOn}.
     */
    static RecordingIndex open(Path recording) throws IOException {
        Optional<RecordingIndex> kept = load(recording);
        if (kept.isPresent()) {
            return kept.get();
        }
        PackedReader fresh = new PackedReader();
        return new RecordingIndex(Optional.of(fresh), fresh.summary(), List.of());
    }

    /**
     * Continues building the index.
     *
     * @param recording the current file of the recording
     * @param milliseconds time limit for this call
     * @throws IllegalArgumentException if the file is not a recording
     */
    synchronized void readOn(Path recording, long milliseconds) throws IOException {
        if (reader.isEmpty() || (whole && Files.size(recording) == reader.get().read())) {
            return;
        }
        beginning = beginning.length == 0 ? bytesAt(recording, 0, FINGERPRINT_BYTES) : beginning;
        whole = reader.get().readOn(recording, System.nanoTime() + milliseconds * 1_000_000);
        summary = reader.get().summary();
        points = reader.get().points();
        if (whole && reader.get().read() >= WORTH_A_FILE_BYTES && RecordingFolders.isFinished(recording)) {
            save(recording);
        }
    }

    /** Returns whether a file is still the recording that was indexed. */
    synchronized boolean fits(Path recording) throws IOException {
        long size = Files.size(recording);
        boolean isLongEnough =
                reader.isEmpty() ? size == bytes : size >= reader.get().read();
        return isLongEnough && Arrays.equals(beginning, bytesAt(recording, 0, beginning.length));
    }

    synchronized RunReading reading() {
        return new RunReading(
                summary, whole, points.stream().map(EntryPoint::firstMoment).toList());
    }

    /**
     * Reads the part of the recording between two entry points.
     *
     * @param recording the recording
     * @param piece index of the first entry point
     * @param skipped number of bytes to skip at the start of this part
     * @return records of the recording, preceded by records that describe the state at the entry point; empty at the end
     */
    byte[] piece(Path recording, int piece, long skipped) throws IOException {
        List<EntryPoint> known;
        synchronized (this) {
            known = points;
        }
        if (piece < 0 || piece >= known.size()) {
            return new byte[0];
        }
        EntryPoint point = known.get(piece);
        long length =
                piece + 1 < known.size() ? known.get(piece + 1).unpackedAt() - point.unpackedAt() : Long.MAX_VALUE;
        return unpack(recording, point, skipped, length);
    }

    private static byte[] unpack(Path recording, EntryPoint point, long skipped, long length) throws IOException {
        EntryPoint.Known known = point.known();
        ByteArrayOutputStream piece = new ByteArrayOutputStream();
        piece.write(known.records());
        Inflater inflater = new Inflater(true);
        try (SeekableByteChannel channel = Files.newByteChannel(recording)) {
            inflater.setDictionary(known.window());
            channel.position(point.packedAt());
            ByteBuffer packed = ByteBuffer.allocate(BUFFER_BYTES);
            byte[] output = new byte[BUFFER_BYTES];
            long rest = length;
            while (rest > 0 && piece.size() < skipped + MAX_PIECE_BYTES) {
                int count = inflater.inflate(output, 0, (int) Math.min(rest, output.length));
                piece.write(output, 0, count);
                rest -= count;
                if (count == 0 && (inflater.finished() || channel.read(packed.clear()) <= 0)) {
                    break;
                }
                if (count == 0) {
                    inflater.setInput(packed.array(), 0, packed.position());
                }
            }
        } catch (DataFormatException endOfWhatIsGood) {
            // The bytes before the damaged part are valid.
        } finally {
            inflater.end();
        }
        byte[] bytes = piece.toByteArray();
        int from = (int) Math.min(skipped, bytes.length);
        return Arrays.copyOfRange(bytes, from, bytes.length);
    }

    private void save(Path recording) throws IOException {
        Path file = new RecordingGroup(recording).beside(RecordingGroup.INDEX);
        try (DataOutputStream out =
                new DataOutputStream(new BufferedOutputStream(Files.newOutputStream(AtomicFile.part(file))))) {
            out.writeUTF(MAGIC);
            out.writeLong(Files.size(recording));
            out.writeLong(fingerprint(recording, Files.size(recording)));
            byte[] json = summary.toString().getBytes(StandardCharsets.UTF_8);
            out.writeInt(json.length);
            out.write(json);
            out.writeInt(points.size());
            for (EntryPoint point : points) {
                point.write(out);
            }
        } catch (IOException diskFullOrReadOnly) {
            Files.deleteIfExists(AtomicFile.part(file));
            return;
        }
        AtomicFile.moveIntoPlace(file);
    }

    private static Optional<RecordingIndex> load(Path recording) {
        Path file = new RecordingGroup(recording).beside(RecordingGroup.INDEX);
        if (!Files.exists(file)) {
            return Optional.empty();
        }
        try (DataInputStream in = new DataInputStream(new BufferedInputStream(Files.newInputStream(file)))) {
            long size = Files.size(recording);
            boolean fits = in.readUTF().equals(MAGIC)
                    && in.readLong() == size
                    && in.readLong() == fingerprint(recording, size);
            if (!fits) {
                return Optional.empty();
            }
            JsonObject summary = JsonParser.parseString(new String(in.readNBytes(in.readInt()), StandardCharsets.UTF_8))
                    .getAsJsonObject();
            List<EntryPoint> points = new ArrayList<>();
            for (int count = in.readInt(); count > 0; count--) {
                points.add(EntryPoint.read(in));
            }
            RecordingIndex index = new RecordingIndex(Optional.empty(), summary, List.copyOf(points));
            index.beginning = bytesAt(recording, 0, FINGERPRINT_BYTES);
            index.bytes = size;
            return Optional.of(index);
        } catch (IOException | RuntimeException damaged) {
            return Optional.empty();
        }
    }

    /** Computes a fingerprint of a recording from its first and last bytes; the last bytes contain the gzip checksum. */
    private static long fingerprint(Path recording, long size) throws IOException {
        CRC32 sum = new CRC32();
        sum.update(bytesAt(recording, 0, FINGERPRINT_BYTES));
        sum.update(bytesAt(recording, Math.max(0, size - FINGERPRINT_BYTES), FINGERPRINT_BYTES));
        return sum.getValue();
    }

    private static byte[] bytesAt(Path recording, long at, int most) throws IOException {
        try (SeekableByteChannel channel = Files.newByteChannel(recording)) {
            ByteBuffer bytes = ByteBuffer.allocate(most);
            channel.position(at);
            channel.read(bytes);
            return Arrays.copyOf(bytes.array(), bytes.position());
        }
    }
}

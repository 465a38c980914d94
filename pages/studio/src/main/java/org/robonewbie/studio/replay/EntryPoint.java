package org.robonewbie.studio.replay;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.zip.DeflaterOutputStream;
import java.util.zip.InflaterInputStream;

/**
 * Random-access point in a compressed recording.
 *
 * @param packedAt offset in the file at which the compressed bytes after this point begin
 * @param unpackedAt number of uncompressed bytes before this point
 * @param firstMoment index of the first cycle after this point
 * @param content compressed decoder state: records that describe the world at this point, and the preceding window of bytes
 */
@SuppressWarnings("ArrayRecordComponent")
record EntryPoint(long packedAt, long unpackedAt, int firstMoment, byte[] content) {

    /** Decoder state at an entry point. */
    @SuppressWarnings("ArrayRecordComponent")
    record Known(byte[] records, byte[] window) {}

    static EntryPoint of(long packedAt, long unpackedAt, int firstMoment, Known known) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (DataOutputStream out = new DataOutputStream(new DeflaterOutputStream(bytes))) {
            out.writeInt(known.records().length);
            out.write(known.records());
            out.write(known.window());
        }
        return new EntryPoint(packedAt, unpackedAt, firstMoment, bytes.toByteArray());
    }

    Known known() throws IOException {
        try (DataInputStream in = new DataInputStream(new InflaterInputStream(new ByteArrayInputStream(content)))) {
            byte[] records = in.readNBytes(in.readInt());
            return new Known(records, in.readAllBytes());
        }
    }

    void write(DataOutputStream out) throws IOException {
        out.writeLong(packedAt);
        out.writeLong(unpackedAt);
        out.writeInt(firstMoment);
        out.writeInt(content.length);
        out.write(content);
    }

    static EntryPoint read(DataInputStream in) throws IOException {
        return new EntryPoint(in.readLong(), in.readLong(), in.readInt(), in.readNBytes(in.readInt()));
    }
}

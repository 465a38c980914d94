package org.robonewbie.studio.replay;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.zip.DeflaterOutputStream;
import java.util.zip.InflaterInputStream;

/**
 * A place in a packed recording at which one can begin to read.
 *
 * @param packedAt where the packed bytes go on, from the begin of the file
 * @param unpackedAt how many unpacked bytes lie before it
 * @param firstMoment index of the first cycle behind it
 * @param content what has to be known there, packed: the records that say how things stood, and the window of bytes before it
 */
@SuppressWarnings("ArrayRecordComponent")
record EntryPoint(long packedAt, long unpackedAt, int firstMoment, byte[] content) {

    /** What has to be known at an entry point. */
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

package org.robonewbie.learning.dataset;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Rows of a Parquet file that were written together, and where each of their columns lies. The numbers in the code are those of the
 * format's own description, parquet.thrift.
 *
 * @param rows how many rows
 * @param chunks for each column where it lies
 */
record ParquetGroup(int rows, List<Chunk> chunks) {

    static final int MAGIC_BYTES = 4;
    static final int PLAIN = 0;
    static final int RUN_LENGTHS = 3;
    private static final int GZIP = 2;

    /** Where a column of a group of rows lies in the file. */
    record Chunk(Column column, long offset, long plainBytes, long storedBytes, Statistics statistics) {

        private Chunk moved(long bytes) {
            return new Chunk(column, offset + bytes, plainBytes, storedBytes, statistics);
        }
    }

    /** What a reader may know of a group without reading it; smallest and largest number are missing for texts. */
    record Statistics(long missing, Optional<byte[]> least, Optional<byte[]> greatest) {

        static final Statistics OF_TEXTS = new Statistics(0, Optional.empty(), Optional.empty());
    }

    /** The groups of a file, and where their bytes end. */
    record Groups(List<ParquetGroup> all, long end) {}

    /** The same group, at another place. */
    ParquetGroup moved(long bytes) {
        return new ParquetGroup(
                rows, chunks.stream().map(chunk -> chunk.moved(bytes)).toList());
    }

    /** The kind of the numbers of a column. */
    static int type(Column column) {
        return switch (column.kind()) {
            case WHOLE -> 2;
            case DECIMAL -> 5;
            case TEXT -> 6;
        };
    }

    /** Appends the description of the group. */
    void describe(CompactThrift all) {
        all.element().structures(1, chunks.size());
        chunks.forEach(chunk -> describe(all, chunk));
        all.longNumber(2, chunks.stream().mapToLong(Chunk::plainBytes).sum());
        all.longNumber(3, rows).end();
    }

    private void describe(CompactThrift all, Chunk chunk) {
        all.element()
                .longNumber(2, chunk.offset())
                .structure(3)
                .number(1, type(chunk.column()))
                .numbers(2, PLAIN, RUN_LENGTHS)
                .texts(3, chunk.column().name())
                .number(4, GZIP)
                .longNumber(5, rows)
                .longNumber(6, chunk.plainBytes())
                .longNumber(7, chunk.storedBytes())
                .longNumber(9, chunk.offset())
                .structure(12)
                .longNumber(3, chunk.statistics().missing());
        chunk.statistics().greatest().ifPresent(number -> all.bytes(5, number));
        chunk.statistics().least().ifPresent(number -> all.bytes(6, number));
        all.end().end().end();
    }

    /** Reads the groups of a file that was written by {@link ParquetFile} with the same columns. */
    static Groups read(Path file, List<Column> columns) throws IOException {
        try (RandomAccessFile in = new RandomAccessFile(file.toFile(), "r")) {
            byte[] end = bytes(in, in.length() - Integer.BYTES - MAGIC_BYTES, Integer.BYTES);
            int length = littleEndian(end).getInt();
            long start = in.length() - Integer.BYTES - MAGIC_BYTES - length;
            Map<Integer, Object> description = new ThriftFields(littleEndian(bytes(in, start, length))).structure();
            List<ParquetGroup> groups = new ArrayList<>();
            for (Object group : list(description, 4)) {
                groups.add(group(structure(group), columns));
            }
            return new Groups(groups, start);
        } catch (BufferUnderflowException | ClassCastException | IllegalArgumentException damaged) {
            throw new IOException(file + " is damaged. Delete it; the same command makes it again.", damaged);
        }
    }

    private static ParquetGroup group(Map<Integer, Object> fields, List<Column> columns) {
        List<Object> described = list(fields, 1);
        if (described.size() != columns.size()) {
            throw new IllegalArgumentException("other columns");
        }
        List<Chunk> chunks = new ArrayList<>();
        for (int i = 0; i < columns.size(); i++) {
            Map<Integer, Object> chunk = structure(at(structure(described.get(i)), 3));
            Map<Integer, Object> known = structure(at(chunk, 12));
            Statistics statistics = new Statistics(
                    number(known, 3), Optional.ofNullable((byte[]) known.get(6)), Optional.ofNullable((byte[])
                            known.get(5)));
            chunks.add(new Chunk(columns.get(i), number(chunk, 9), number(chunk, 6), number(chunk, 7), statistics));
        }
        return new ParquetGroup((int) number(fields, 3), chunks);
    }

    private static byte[] bytes(RandomAccessFile in, long position, int count) throws IOException {
        if (position < 0 || count < 0) {
            throw new IllegalArgumentException("too short");
        }
        byte[] all = new byte[count];
        in.seek(position);
        in.readFully(all);
        return all;
    }

    private static ByteBuffer littleEndian(byte... bytes) {
        return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    }

    private static Object at(Map<Integer, Object> fields, int field) {
        Object value = fields.get(field);
        if (value == null) {
            throw new IllegalArgumentException("no field " + field);
        }
        return value;
    }

    private static long number(Map<Integer, Object> fields, int field) {
        return (Long) at(fields, field);
    }

    @SuppressWarnings("unchecked")
    private static List<Object> list(Map<Integer, Object> fields, int field) {
        return (List<Object>) at(fields, field);
    }

    @SuppressWarnings("unchecked")
    private static Map<Integer, Object> structure(Object value) {
        return (Map<Integer, Object>) value;
    }
}

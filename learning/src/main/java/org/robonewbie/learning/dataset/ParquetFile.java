package org.robonewbie.learning.dataset;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.zip.GZIPOutputStream;

/**
 * A table in the format of Apache Parquet, version 1, in its plainest form: all columns required, one page per column and group
 * of rows, numbers as they are in memory (encoding PLAIN), each page compressed with gzip. The numbers in the code are those of
 * the format's own description, parquet.thrift.
 */
final class ParquetFile extends TableFile {

    private static final byte[] MAGIC = "PAR1".getBytes(StandardCharsets.US_ASCII);
    private static final int ROWS_PER_GROUP = 20_000;
    private static final int PLAIN = 0;
    private static final int RUN_LENGTHS = 3;
    private static final int GZIP = 2;
    private static final int REQUIRED = 0;
    private static final int UTF_8 = 0;

    private final Map<String, String> facts;
    private final List<Group> groups = new ArrayList<>();
    private final List<List<Object>> waiting = new ArrayList<>();
    private long position;

    /** Where a column of a group of rows lies in the file. */
    private record Chunk(Column column, long offset, long plainBytes, long storedBytes) {}

    /** Rows that were written together. */
    private record Group(int rows, List<Chunk> chunks) {}

    ParquetFile(Path file, List<Column> columns, Map<String, String> facts) throws IOException {
        super(file, columns);
        this.facts = Map.copyOf(facts);
        append(MAGIC);
    }

    @Override
    void write(List<Object> cells) throws IOException {
        waiting.add(List.copyOf(cells));
        if (waiting.size() == ROWS_PER_GROUP) {
            writeGroup();
        }
    }

    @Override
    void writeEnd() throws IOException {
        if (!waiting.isEmpty()) {
            writeGroup();
        }
        byte[] description = description();
        append(description);
        append(littleEndian(Integer.BYTES).putInt(description.length).array());
        append(MAGIC);
    }

    private void writeGroup() throws IOException {
        List<Chunk> chunks = new ArrayList<>();
        for (int i = 0; i < columns().size(); i++) {
            chunks.add(writePage(columns().get(i), i));
        }
        groups.add(new Group(waiting.size(), chunks));
        waiting.clear();
    }

    private Chunk writePage(Column column, int index) throws IOException {
        byte[] plain = plain(column, index);
        byte[] stored = compressed(plain);
        byte[] header = new CompactThrift()
                .number(1, 0)
                .number(2, plain.length)
                .number(3, stored.length)
                .structure(5)
                .number(1, waiting.size())
                .number(2, PLAIN)
                .number(3, RUN_LENGTHS)
                .number(4, RUN_LENGTHS)
                .end()
                .toBytes();
        Chunk chunk = new Chunk(column, position, header.length + plain.length, header.length + stored.length);
        append(header);
        append(stored);
        return chunk;
    }

    private byte[] plain(Column column, int index) {
        if (column.kind() == Column.Kind.TEXT) {
            return plainTexts(index);
        }
        byte[] bytes = new byte[waiting.size() * Long.BYTES];
        ByteBuffer numbers = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        for (List<Object> row : waiting) {
            if (column.kind() == Column.Kind.WHOLE) {
                numbers.putLong((Long) row.get(index));
            } else {
                numbers.putDouble((Double) row.get(index));
            }
        }
        return bytes;
    }

    private byte[] plainTexts(int index) {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        for (List<Object> row : waiting) {
            byte[] text = ((String) row.get(index)).getBytes(StandardCharsets.UTF_8);
            all.writeBytes(littleEndian(Integer.BYTES).putInt(text.length).array());
            all.writeBytes(text);
        }
        return all.toByteArray();
    }

    private static byte[] compressed(byte[] plain) throws IOException {
        ByteArrayOutputStream stored = new ByteArrayOutputStream();
        try (GZIPOutputStream gzip = new GZIPOutputStream(stored)) {
            gzip.write(plain);
        }
        return stored.toByteArray();
    }

    private byte[] description() {
        CompactThrift all = new CompactThrift().number(1, 1);
        describeColumns(all);
        all.longNumber(3, groups.stream().mapToLong(Group::rows).sum());
        all.structures(4, groups.size());
        groups.forEach(group -> describe(all, group));
        all.structures(5, facts.size());
        facts.entrySet().stream()
                .sorted(Map.Entry.comparingByKey())
                .forEach(fact -> all.element()
                        .text(1, fact.getKey())
                        .text(2, fact.getValue())
                        .end());
        return all.text(6, "RoboNewbie").toBytes();
    }

    private void describeColumns(CompactThrift all) {
        all.structures(2, columns().size() + 1);
        all.element().text(4, "schema").number(5, columns().size()).end();
        for (Column column : columns()) {
            all.element().number(1, type(column)).number(3, REQUIRED).text(4, column.name());
            if (column.kind() == Column.Kind.TEXT) {
                all.number(6, UTF_8);
            }
            all.end();
        }
    }

    private static void describe(CompactThrift all, Group group) {
        all.element().structures(1, group.chunks().size());
        group.chunks().forEach(chunk -> describe(all, chunk, group.rows()));
        all.longNumber(2, group.chunks().stream().mapToLong(Chunk::plainBytes).sum());
        all.longNumber(3, group.rows()).end();
    }

    private static void describe(CompactThrift all, Chunk chunk, int rows) {
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
                .end()
                .end();
    }

    private static int type(Column column) {
        return switch (column.kind()) {
            case WHOLE -> 2;
            case DECIMAL -> 5;
            case TEXT -> 6;
        };
    }

    private static ByteBuffer littleEndian(int bytes) {
        return ByteBuffer.allocate(bytes).order(ByteOrder.LITTLE_ENDIAN);
    }

    private void append(byte[] bytes) throws IOException {
        out().write(bytes);
        position += bytes.length;
    }
}

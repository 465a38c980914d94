package org.robonewbie.learning.dataset;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.LongSummaryStatistics;
import java.util.Map;
import java.util.Optional;
import java.util.zip.GZIPOutputStream;

/**
 * A table in the format of Apache Parquet, version 1, in its plainest form: one page per column and group of rows, numbers as they
 * are in memory (encoding PLAIN), each page compressed with gzip. A decimal number that is none (NaN) is a missing one (null). The
 * numbers in the code are those of the format's own description, parquet.thrift.
 */
final class ParquetFile extends TableFile {

    private static final byte[] MAGIC = "PAR1".getBytes(StandardCharsets.US_ASCII);
    private static final int ROWS_PER_GROUP = 20_000;
    private static final int COPIED_AT_ONCE = 1 << 20;
    private static final int REQUIRED = 0;
    private static final int OPTIONAL = 1;
    private static final int UTF_8 = 0;

    private final Map<String, String> facts;
    private final List<ParquetGroup> groups = new ArrayList<>();
    private final List<List<Object>> waiting = new ArrayList<>();
    private long position;

    /** The cells of a column as they stand in the file before they are compressed. */
    @SuppressWarnings("ArrayRecordComponent")
    private record Page(byte[] plain, ParquetGroup.Statistics statistics) {}

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

    /** Takes over the bytes of another file's groups as they are; only where they lie is described again. */
    @Override
    void append(Path other) throws IOException {
        if (!waiting.isEmpty()) {
            writeGroup();
        }
        ParquetGroup.Groups added = ParquetGroup.read(other, columns());
        long way = position - MAGIC.length;
        added.all().forEach(group -> groups.add(group.moved(way)));
        try (InputStream in = Files.newInputStream(other)) {
            in.skipNBytes(MAGIC.length);
            for (long rest = added.end() - MAGIC.length; rest > 0; ) {
                byte[] bytes = in.readNBytes((int) Math.min(rest, COPIED_AT_ONCE));
                append(bytes);
                rest -= bytes.length;
            }
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
        List<ParquetGroup.Chunk> chunks = new ArrayList<>();
        for (int i = 0; i < columns().size(); i++) {
            chunks.add(writePage(columns().get(i), i));
        }
        groups.add(new ParquetGroup(waiting.size(), chunks));
        waiting.clear();
    }

    private ParquetGroup.Chunk writePage(Column column, int index) throws IOException {
        Page page = page(column, index);
        byte[] plain = page.plain();
        byte[] stored = compressed(plain);
        byte[] header = new CompactThrift()
                .number(1, 0)
                .number(2, plain.length)
                .number(3, stored.length)
                .structure(5)
                .number(1, waiting.size())
                .number(2, ParquetGroup.PLAIN)
                .number(3, ParquetGroup.RUN_LENGTHS)
                .number(4, ParquetGroup.RUN_LENGTHS)
                .end()
                .toBytes();
        ParquetGroup.Chunk chunk = new ParquetGroup.Chunk(
                column, position, header.length + plain.length, header.length + stored.length, page.statistics());
        append(header);
        append(stored);
        return chunk;
    }

    private Page page(Column column, int index) {
        return switch (column.kind()) {
            case TEXT -> new Page(plainTexts(index), ParquetGroup.Statistics.OF_TEXTS);
            case WHOLE -> {
                long[] all =
                        waiting.stream().mapToLong(row -> (Long) row.get(index)).toArray();
                yield new Page(plain(all), statistics(all));
            }
            case DECIMAL -> {
                double[] all = waiting.stream()
                        .mapToDouble(row -> (Double) row.get(index))
                        .toArray();
                yield new Page(plain(all), statistics(all));
            }
        };
    }

    private static byte[] plain(long... all) {
        byte[] page = new byte[all.length * Long.BYTES];
        ByteBuffer.wrap(page).order(ByteOrder.LITTLE_ENDIAN).asLongBuffer().put(all);
        return page;
    }

    /** First which of the numbers are there, then those. */
    private static byte[] plain(double... all) {
        byte[] levels = levels(all);
        double[] present =
                Arrays.stream(all).filter(number -> !Double.isNaN(number)).toArray();
        byte[] page = new byte[Integer.BYTES + levels.length + present.length * Double.BYTES];
        ByteBuffer content = ByteBuffer.wrap(page).order(ByteOrder.LITTLE_ENDIAN);
        content.putInt(levels.length).put(levels);
        for (double number : present) {
            content.putDouble(number);
        }
        return page;
    }

    /** Runs of numbers that are there (1) or missing (0): twice the length of each run, then which. */
    private static byte[] levels(double... numbers) {
        ByteArrayOutputStream runs = new ByteArrayOutputStream();
        int start = 0;
        for (int i = 1; i <= numbers.length; i++) {
            if (i == numbers.length || Double.isNaN(numbers[i]) != Double.isNaN(numbers[start])) {
                CompactThrift.writeUnsigned(runs, 2L * (i - start));
                runs.write(Double.isNaN(numbers[start]) ? 0 : 1);
                start = i;
            }
        }
        return runs.toByteArray();
    }

    private static ParquetGroup.Statistics statistics(long... numbers) {
        LongSummaryStatistics all = Arrays.stream(numbers).summaryStatistics();
        return new ParquetGroup.Statistics(0, Optional.of(bytes(all.getMin())), Optional.of(bytes(all.getMax())));
    }

    /** Zeros get the sign with which no reader skips a group that has the other zero. */
    private static ParquetGroup.Statistics statistics(double... numbers) {
        DoubleSummaryStatistics all =
                Arrays.stream(numbers).filter(number -> !Double.isNaN(number)).summaryStatistics();
        long missing = numbers.length - all.getCount();
        if (all.getCount() == 0) {
            return new ParquetGroup.Statistics(missing, Optional.empty(), Optional.empty());
        }
        double least = all.getMin() == 0 ? -0.0 : all.getMin();
        double greatest = all.getMax() == 0 ? 0.0 : all.getMax();
        return new ParquetGroup.Statistics(
                missing,
                Optional.of(bytes(Double.doubleToLongBits(least))),
                Optional.of(bytes(Double.doubleToLongBits(greatest))));
    }

    private static byte[] bytes(long number) {
        return littleEndian(Long.BYTES).putLong(number).array();
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
        all.longNumber(3, groups.stream().mapToLong(ParquetGroup::rows).sum());
        all.structures(4, groups.size());
        groups.forEach(group -> group.describe(all));
        all.structures(5, facts.size());
        facts.entrySet().stream()
                .sorted(Map.Entry.comparingByKey())
                .forEach(fact -> all.element()
                        .text(1, fact.getKey())
                        .text(2, fact.getValue())
                        .end());
        all.text(6, "RoboNewbie").structures(7, columns().size());
        columns().forEach(column -> all.element().structure(1).end().end()); // the usual order of each type
        return all.toBytes();
    }

    private void describeColumns(CompactThrift all) {
        all.structures(2, columns().size() + 1);
        all.element().text(4, "schema").number(5, columns().size()).end();
        for (Column column : columns()) {
            all.element()
                    .number(1, ParquetGroup.type(column))
                    .number(3, repetition(column))
                    .text(4, column.name());
            if (column.kind() == Column.Kind.TEXT) {
                all.number(6, UTF_8);
            }
            all.end();
        }
    }

    private static int repetition(Column column) {
        return column.kind() == Column.Kind.DECIMAL ? OPTIONAL : REQUIRED;
    }

    private static ByteBuffer littleEndian(int bytes) {
        return ByteBuffer.allocate(bytes).order(ByteOrder.LITTLE_ENDIAN);
    }

    private void append(byte[] bytes) throws IOException {
        out().write(bytes);
        position += bytes.length;
    }
}

package org.robonewbie.learning.dataset;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class TableFileTest {

    private static final List<Column> COLUMNS = List.of(
            Column.whole("run", "", "a number"),
            Column.decimal("true_tilt", "degrees", "an angle"),
            Column.text("event", "words"));

    @TempDir
    private Path folder;

    @Test
    void textIsQuotedWhereItMustBeAndWhatIsMissingIsEmpty() throws IOException {
        write(TableFormat.CSV, List.of(List.of(1L, 0.5, "say \"a,b\""), List.of(-2L, Double.NaN, "")));

        assertThat(folder.resolve("table.csv")).hasContent("run,true_tilt,event\n1,0.5,\"say \"\"a,b\"\"\"\n-2,,\n");
    }

    @Test
    void parquetHoldsEachColumnAsItIs() throws IOException {
        write(TableFormat.PARQUET, List.of(List.of(1L, 0.5, "größer"), List.of(-2L, Double.NaN, "")));

        ByteBuffer file = parquet();
        Map<Integer, Object> description = description(file);
        assertThat(at(description, 3)).isEqualTo(2L);
        assertThat(names(description)).containsExactly("schema", "run", "true_tilt", "event");
        Map<Integer, Object> fact = map(list(at(description, 5)).get(0));
        assertThat(string(at(fact, 1)) + "=" + string(at(fact, 2))).isEqualTo("seed=7");
        ByteBuffer runs = page(file, description, 0, 0);
        assertThat(List.of(runs.getLong(), runs.getLong())).containsExactly(1L, -2L);
        ByteBuffer tilts = page(file, description, 0, 1);
        assertThat(tilts.getInt()).isEqualTo(4);
        byte[] oneIsThereThenOneIsMissing = new byte[4];
        tilts.get(oneIsThereThenOneIsMissing);
        assertThat(oneIsThereThenOneIsMissing).containsExactly(2, 1, 2, 0);
        assertThat(tilts.getDouble()).isEqualTo(0.5);
        assertThat(tilts.remaining()).isZero();
        ByteBuffer events = page(file, description, 0, 2);
        assertThat(List.of(text(events), text(events))).containsExactly("größer", "");
    }

    @Test
    void manyRowsAreWrittenInGroups() throws IOException {
        List<List<Object>> rows = new ArrayList<>();
        for (long i = 0; i < 20_001; i++) {
            rows.add(List.of(i, i / 2.0, ""));
        }

        write(TableFormat.PARQUET, rows);

        ByteBuffer file = parquet();
        Map<Integer, Object> description = description(file);
        assertThat(at(description, 3)).isEqualTo(20_001L);
        assertThat(list(at(description, 4))).hasSize(2);
        assertThat(page(file, description, 1, 0).getLong()).isEqualTo(20_000L);
    }

    @Test
    void rowsOfOtherTablesFollowAsTheyAre() throws IOException {
        write(TableFormat.PARQUET, List.of(List.of(1L, 0.5, "a"), List.of(-2L, Double.NaN, "")));
        write("other", TableFormat.PARQUET, List.of(List.of(3L, -0.25, "b")));
        try (TableFile joined = TableFormat.PARQUET.begin(folder.resolve("joined"), COLUMNS, Map.of("seed", "7"))) {
            joined.append(folder.resolve("table.parquet"));
            joined.append(folder.resolve("other.parquet"));
            joined.finish();
        }

        ByteBuffer file = parquet("joined");
        Map<Integer, Object> description = description(file);
        assertThat(at(description, 3)).isEqualTo(3L);
        assertThat(page(file, description, 0, 0).getLong()).isEqualTo(1L);
        assertThat(page(file, description, 1, 0).getLong()).isEqualTo(3L);
        assertThat(text(page(file, description, 1, 2))).isEqualTo("b");
    }

    @Test
    void tableThatIsDamagedIsNamed() throws IOException {
        Path damaged = folder.resolve("damaged.parquet");
        write(TableFormat.PARQUET, List.of(List.of(1L, 0.5, "a")));
        byte[] good = Files.readAllBytes(folder.resolve("table.parquet"));
        try (TableFile joined = TableFormat.PARQUET.begin(folder.resolve("joined"), COLUMNS, Map.of())) {
            for (int length = 0; length < good.length; length++) {
                Files.write(damaged, Arrays.copyOf(good, length));
                assertThatThrownBy(() -> joined.append(damaged))
                        .isInstanceOf(IOException.class)
                        .hasMessageContaining("damaged.parquet is damaged");
            }
        }
    }

    @Test
    void tableThatIsGivenUpLeavesNothing() throws IOException {
        try (TableFile table = TableFormat.PARQUET.begin(folder.resolve("table"), COLUMNS, Map.of())) {
            table.add(List.of(1L, 0.5, ""));
        }

        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void rowOfAnotherLengthIsRefused() throws IOException {
        try (TableFile table = TableFormat.CSV.begin(folder.resolve("table"), COLUMNS, Map.of())) {
            assertThatThrownBy(() -> table.add(List.of(1L)))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("A row of 1 cells for a table with 3 columns");
        }
    }

    private void write(TableFormat format, List<List<Object>> rows) throws IOException {
        write("table", format, rows);
    }

    private void write(String name, TableFormat format, List<List<Object>> rows) throws IOException {
        try (TableFile table = format.begin(folder.resolve(name), COLUMNS, Map.of("seed", "7"))) {
            for (List<Object> row : rows) {
                table.add(row);
            }
            table.finish();
        }
    }

    private ByteBuffer parquet() throws IOException {
        return parquet("table");
    }

    private ByteBuffer parquet(String name) throws IOException {
        return ByteBuffer.wrap(Files.readAllBytes(folder.resolve(name + ".parquet")))
                .order(ByteOrder.LITTLE_ENDIAN);
    }

    private static Map<Integer, Object> description(ByteBuffer file) {
        byte[] magic = new byte[4];
        file.get(0, magic);
        assertThat(magic).asString(StandardCharsets.US_ASCII).isEqualTo("PAR1");
        file.get(file.capacity() - 4, magic);
        assertThat(magic).asString(StandardCharsets.US_ASCII).isEqualTo("PAR1");
        int length = file.getInt(file.capacity() - 8);
        return new ThriftFields(file.duplicate().position(file.capacity() - 8 - length)).structure();
    }

    /** The numbers of one column of one group, unpacked. */
    private static ByteBuffer page(ByteBuffer file, Map<Integer, Object> description, int group, int column)
            throws IOException {
        Map<Integer, Object> chunk =
                map(list(at(map(list(at(description, 4)).get(group)), 1)).get(column));
        ByteBuffer page = file.duplicate().position((int) (long) at(map(at(chunk, 3)), 9));
        Map<Integer, Object> header = new ThriftFields(page).structure();
        byte[] stored = new byte[(int) (long) at(header, 3)];
        page.get(stored);
        byte[] plain = new GZIPInputStream(new ByteArrayInputStream(stored)).readAllBytes();
        assertThat((long) plain.length).isEqualTo(header.get(2));
        return ByteBuffer.wrap(plain).order(ByteOrder.LITTLE_ENDIAN);
    }

    private static List<String> names(Map<Integer, Object> description) {
        return list(at(description, 2)).stream()
                .map(element -> string(at(map(element), 4)))
                .toList();
    }

    private static String string(Object bytes) {
        return new String((byte[]) bytes, StandardCharsets.UTF_8);
    }

    private static String text(ByteBuffer page) {
        byte[] bytes = new byte[page.getInt()];
        page.get(bytes);
        return new String(bytes, StandardCharsets.UTF_8);
    }

    private static Object at(Map<Integer, Object> fields, int field) {
        return Objects.requireNonNull(fields.get(field));
    }

    @SuppressWarnings("unchecked")
    private static List<Object> list(Object value) {
        return (List<Object>) value;
    }

    @SuppressWarnings("unchecked")
    private static Map<Integer, Object> map(Object value) {
        return (Map<Integer, Object>) value;
    }
}

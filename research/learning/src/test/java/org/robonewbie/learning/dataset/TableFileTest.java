package org.robonewbie.learning.dataset;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
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
        write("table.csv", List.of(List.of(1L, 0.5, "say \"a,b\""), List.of(-2L, Double.NaN, "")));

        assertThat(folder.resolve("table.csv")).hasContent("run,true_tilt,event\n1,0.5,\"say \"\"a,b\"\"\"\n-2,,\n");
    }

    @Test
    void rowsOfOtherTablesFollowAsTheyAre() throws IOException {
        write("table.csv", List.of(List.of(1L, 0.5, "a")));
        write("other.csv", List.of(List.of(3L, -0.25, "größer")));

        try (TableFile joined = new TableFile(folder.resolve("joined.csv"), COLUMNS)) {
            joined.append(folder.resolve("table.csv"));
            joined.append(folder.resolve("other.csv"));
            joined.finish();
        }

        assertThat(folder.resolve("joined.csv")).hasContent("run,true_tilt,event\n1,0.5,a\n3,-0.25,größer\n");
    }

    @Test
    void tableThatIsGivenUpLeavesNothing() throws IOException {
        try (TableFile table = new TableFile(folder.resolve("table.csv"), COLUMNS)) {
            table.add(List.of(1L, 0.5, ""));
        }

        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void rowOfAnotherLengthIsRefused() throws IOException {
        try (TableFile table = new TableFile(folder.resolve("table.csv"), COLUMNS)) {
            assertThatThrownBy(() -> table.add(List.of(1L)))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("A row of 1 cells for a table with 3 columns");
        }
    }

    private void write(String name, List<List<Object>> rows) throws IOException {
        try (TableFile table = new TableFile(folder.resolve(name), COLUMNS)) {
            for (List<Object> row : rows) {
                table.add(row);
            }
            table.finish();
        }
    }
}

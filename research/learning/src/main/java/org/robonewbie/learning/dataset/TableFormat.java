package org.robonewbie.learning.dataset;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** How tables are written. */
public enum TableFormat {

    /** Comma-separated values with a line of names, for people and spreadsheets. */
    CSV,

    /** Apache Parquet, for pandas, DuckDB, Spark and others: smaller, faster, and it knows what its columns are. */
    PARQUET;

    /**
     * Starts a table.
     *
     * @param file its name without the extension of the format; it appears there when it is {@link TableFile#finish finished}
     * @param columns its columns
     * @param facts what the file records about itself, where the format allows it
     * @return the empty table
     * @throws IOException if the file cannot be written
     */
    public TableFile begin(Path file, List<Column> columns, Map<String, String> facts) throws IOException {
        return switch (this) {
            case CSV -> new CsvFile(named(file), columns);
            case PARQUET -> new ParquetFile(named(file), columns, facts);
        };
    }

    /** The name of a file with the extension of the format. */
    Path named(Path file) {
        return file.resolveSibling(file.getFileName() + "." + this);
    }

    /**
     * {@return the format's name on the command line, which is also the extension of its files: {@code csv} or {@code parquet}}
     */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }
}

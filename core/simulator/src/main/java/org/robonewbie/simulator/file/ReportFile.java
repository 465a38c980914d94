package org.robonewbie.simulator.file;

import java.io.IOException;
import java.nio.file.Path;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.simulator.recording.RunReport;

/** The report of a run as a file. */
public final class ReportFile {

    private ReportFile() {}

    /**
     * Writes a report, as a whole or not at all.
     *
     * @param report the report
     * @param file the file
     * @throws IOException if it cannot be written; the message says what to do
     */
    public static void write(RunReport report, Path file) throws IOException {
        AtomicFile.write(file, report.toJson());
    }
}

package org.robonewbie.workshop.fidelity;

import java.util.List;

/**
 * Contiguous run of a server with a row for each cycle of 20 ms.
 *
 * @param name name of the run within its file; empty if it is the only one
 * @param rows at least one row
 */
public record RecordedRun(String name, List<RecordedRow> rows) {}

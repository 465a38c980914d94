package org.robonewbie.workshop.fidelity;

import java.util.List;

/**
 * One unbroken run of a server, a row for each cycle of 20 ms.
 *
 * @param name what the run is called within its file; empty when it is the only one
 * @param rows at least one row
 */
public record RecordedRun(String name, List<RecordedRow> rows) {}

package org.robonewbie.workshop.fidelity;

import java.util.List;

/**
 * Contents of a recording file: one or more runs, each in a fresh world.
 *
 * @param name file name without extension
 * @param header first line as JSON, which describes the recording; empty if missing
 * @param runs runs in file order
 */
public record Recording(String name, String header, List<RecordedRun> runs) {}

package org.robonewbie.workshop.fidelity;

import java.util.List;

/**
 * What one file holds: one or more runs, each on a fresh world.
 *
 * @param name the file's name without its ending
 * @param header what the first line says about how it was made, as JSON; empty without one
 * @param runs in the order of the file
 */
public record Recording(String name, String header, List<RecordedRun> runs) {}

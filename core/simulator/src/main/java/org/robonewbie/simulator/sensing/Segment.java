package org.robonewbie.simulator.sensing;

import org.robonewbie.nao.Vector3;

/**
 * A straight piece of a line.
 *
 * @param start one end, metres
 * @param end the other end, metres
 */
record Segment(Vector3 start, Vector3 end) {}

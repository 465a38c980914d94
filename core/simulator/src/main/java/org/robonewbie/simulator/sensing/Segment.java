package org.robonewbie.simulator.sensing;

import org.robonewbie.nao.Vector3;

/**
 * Line segment.
 *
 * @param start start point in metres
 * @param end end point in metres
 */
record Segment(Vector3 start, Vector3 end) {}

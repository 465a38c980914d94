package org.robonewbie.agent.perception;

/**
 * A segment of a field line in the last camera picture. Segments have no identity, so they are not remembered.
 *
 * @param start direction of one end
 * @param end direction of the other end; the order of the ends has no meaning
 */
public record LineItem(Direction start, Direction end) {}

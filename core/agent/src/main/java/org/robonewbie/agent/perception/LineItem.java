package org.robonewbie.agent.perception;

/**
 * A piece of a line of the field in the last picture of the camera. Lines have no names, so they are not remembered.
 *
 * @param start where one end is seen
 * @param end where the other end is seen; which one is the start has no meaning
 */
public record LineItem(Direction start, Direction end) {}

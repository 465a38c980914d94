package org.robonewbie.protocol.telemetry;

import org.robonewbie.nao.Vector3;

/**
 * A shape that a robot draws into its surroundings to show what it thinks. Points are metres from the centre of its head along
 * the axes of its torso (x forward, y left, z up), as in its field view. Colours are CSS names or codes, such as {@code red} or
 * {@code #ff8800}; an unknown colour is replaced.
 */
public sealed interface Drawing {

    /** {@return the colour of the shape as a CSS name or code} */
    String colour();

    /**
     * A point.
     *
     * @param place where it is
     * @param colour its colour
     */
    record Point(Vector3 place, String colour) implements Drawing {}

    /**
     * A straight line.
     *
     * @param from its start
     * @param to its end
     * @param colour its colour
     */
    record Line(Vector3 from, Vector3 to, String colour) implements Drawing {}

    /**
     * A horizontal circle.
     *
     * @param centre its centre
     * @param radius its radius in metres
     * @param colour its colour
     */
    record Circle(Vector3 centre, double radius, String colour) implements Drawing {}

    /**
     * A text.
     *
     * @param place its position
     * @param text the text
     * @param colour its colour
     */
    record Text(Vector3 place, String text, String colour) implements Drawing {}
}

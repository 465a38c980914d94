package org.robonewbie.protocol.telemetry;

import org.robonewbie.nao.Vector3;

/**
 * A shape that a robot's program draws into the scene for debugging. Points are relative to the centre of the robot's
 * head along the axes of its torso (x forward, y left, z up), in metres, like positions in the robot's field view.
 * Colours are CSS names or codes, such as {@code red} or {@code #ff8800}; viewers replace an unknown colour with a
 * default.
 */
public sealed interface Drawing {

    /** {@return the colour of the shape as a CSS name or code} */
    String colour();

    /**
     * A point.
     *
     * @param place position of the point
     * @param colour colour of the point
     */
    record Point(Vector3 place, String colour) implements Drawing {}

    /**
     * A straight line.
     *
     * @param from start of the line
     * @param to end of the line
     * @param colour colour of the line
     */
    record Line(Vector3 from, Vector3 to, String colour) implements Drawing {}

    /**
     * A horizontal circle.
     *
     * @param centre centre of the circle
     * @param radius radius in metres
     * @param colour colour of the circle
     */
    record Circle(Vector3 centre, double radius, String colour) implements Drawing {}

    /**
     * A text label.
     *
     * @param place position of the text
     * @param text the text
     * @param colour colour of the text
     */
    record Text(Vector3 place, String text, String colour) implements Drawing {}
}

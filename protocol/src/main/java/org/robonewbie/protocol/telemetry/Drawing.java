package org.robonewbie.protocol.telemetry;

import org.robonewbie.nao.Vector3;

/**
 * A shape that a robot draws into its surroundings to show what it thinks. Points are metres from the centre of its head along the
 * axes of its torso (x forward, y left, z up), as in its field view. Colours are names or codes as in web pages, such as {@code
 * red} or {@code #ff8800}; who does not know a colour takes another one.
 */
public sealed interface Drawing {

    /**
     * Names the colour of the shape.
     *
     * @return a name or code as in web pages
     */
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
     * @param from where it begins
     * @param to where it ends
     * @param colour its colour
     */
    record Line(Vector3 from, Vector3 to, String colour) implements Drawing {}

    /**
     * A level circle.
     *
     * @param centre its centre
     * @param radius metres from the centre to the line
     * @param colour its colour
     */
    record Circle(Vector3 centre, double radius, String colour) implements Drawing {}

    /**
     * A text.
     *
     * @param place where it stands
     * @param text what it says
     * @param colour its colour
     */
    record Text(Vector3 place, String text, String colour) implements Drawing {}
}

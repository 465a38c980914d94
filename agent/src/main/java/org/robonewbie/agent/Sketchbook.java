package org.robonewbie.agent;

import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.telemetry.BelievedPose;
import org.robonewbie.protocol.telemetry.Drawing;

/**
 * Draws what a robot thinks into the studio's picture of its surroundings. All drawings of one cycle form a picture, which stays
 * until the next one, a second at most. Without a studio nothing happens, so drawings may stay in a finished program.
 *
 * <p>Points are metres from the centre of the head: x forward, y left, z up, as in the field view. Colours are names or codes as
 * in web pages, such as {@code red} or {@code #ff8800}.
 */
abstract class Sketchbook {

    abstract Thoughts thoughts();

    /**
     * Draws a point.
     *
     * @param place where, in metres from the head
     * @param colour a name or code as in web pages
     */
    public final void drawPoint(Vector3 place, String colour) {
        thoughts().draw(new Drawing.Point(place, colour));
    }

    /**
     * Draws a straight line.
     *
     * @param from where it begins, in metres from the head
     * @param to where it ends, in metres from the head
     * @param colour a name or code as in web pages
     */
    public final void drawLine(Vector3 from, Vector3 to, String colour) {
        thoughts().draw(new Drawing.Line(from, to, colour));
    }

    /**
     * Draws a level circle.
     *
     * @param centre its centre, in metres from the head
     * @param radius in metres
     * @param colour a name or code as in web pages
     */
    public final void drawCircle(Vector3 centre, double radius, String colour) {
        thoughts().draw(new Drawing.Circle(centre, radius, colour));
    }

    /**
     * Writes a text into the picture.
     *
     * @param place where, in metres from the head
     * @param text what it says
     * @param colour a name or code as in web pages
     */
    public final void drawText(Vector3 place, String text, String colour) {
        thoughts().draw(new Drawing.Text(place, text, colour));
    }

    /**
     * Adds a value to a curve over time in the studio.
     *
     * @param curve name of the curve; each name has one of its own
     * @param value the value in this cycle, in a unit of your choice
     */
    public final void plot(String curve, double value) {
        thoughts().plot(curve, value);
    }

    /**
     * Shows in the studio where the robot believes to be.
     *
     * @param x metres from the centre towards the opponents' goal
     * @param y metres to the left of that
     * @param headingDegrees direction of the torso; 0 is towards the opponents' goal, positive is left
     */
    public final void tellPose(double x, double y, double headingDegrees) {
        thoughts().locate(new BelievedPose(x, y, headingDegrees));
    }
}

package org.robonewbie.competition.contest;

import java.util.Locale;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;

/**
 * Start pose of a robot in its team's coordinates: the origin is the centre spot, x points towards the opponents' goal and y to the
 * left.
 *
 * @param number number of the robot, 1 to 11
 * @param x x coordinate in metres
 * @param y y coordinate in metres
 * @param degrees heading in degrees; 0 is towards the opponents' goal, positive is to the left
 */
public record StartPlace(int number, double x, double y, double degrees) {

    /** Torso height of a standing robot. */
    private static final double TORSO_METRES = 0.4;

    /**
     * Formats the pose as an argument for the agents' option {@code --pose}.
     *
     * @return the argument, such as {@code -0.5,0.4,-40}
     */
    public String pose() {
        return text(x) + "," + text(y) + "," + text(degrees);
    }

    /**
     * Returns the position in the world frame.
     *
     * @param side the team's half
     * @return position of the torso's centre in metres
     */
    public Vector3 position(TeamSide side) {
        return side.inOtherFrame(new Vector3(x, y, TORSO_METRES));
    }

    /**
     * Returns the heading in the world frame.
     *
     * @param side the team's half
     * @return heading in degrees; 0 is towards the right goal, positive is counter-clockwise
     */
    public double heading(TeamSide side) {
        return side == TeamSide.LEFT ? degrees : degrees + 180;
    }

    private static String text(double value) {
        String text = String.format(Locale.ROOT, "%.3f", value).replaceFirst("\\.?0+$", "");
        return text.equals("-0") ? "0" : text;
    }
}

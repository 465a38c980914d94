package org.robonewbie.simulator.soccer;

import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;

/** Start positions of a team along the side line. As in SimSpark, a position is never reused. */
public final class StartPositions {

    private final double radius;
    private final double halfWidth;
    private double x;
    private double y;

    /**
     * Creates the start positions for a team.
     *
     * @param side side of the team
     * @param parameters size of the pitch and radius of a robot
     */
    public StartPositions(TeamSide side, SoccerParameters parameters) {
        SoccerField field = parameters.field();
        radius = parameters.get(SoccerParameter.AGENT_RADIUS);
        halfWidth = field.width() / 2;
        double distance = field.length() / 2 - 2 * radius;
        x = side == TeamSide.LEFT ? -distance : distance;
        y = halfWidth - 2 * radius;
    }

    /**
     * Returns the next position.
     *
     * @return position of the torso in the world frame in metres
     */
    public Vector3 next() {
        Vector3 position = new Vector3(x, y, radius);
        y -= 3 * radius;
        if (y < -halfWidth) {
            y = halfWidth - 2 * radius;
            x += 2 * radius;
        }
        return position;
    }

    void save(StateWriter out) {
        out.putDouble(x);
        out.putDouble(y);
    }

    void restore(StateReader in) {
        x = in.getDouble();
        y = in.getDouble();
    }
}

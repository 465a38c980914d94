package org.robonewbie.simulator.soccer;

import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;

/** The row of places at the side line where new players of a team appear; as in SimSpark a place is never reused. */
public final class StartPositions {

    private final double radius;
    private final double halfWidth;
    private double x;
    private double y;

    /**
     * Begins with the place of the first player.
     *
     * @param side the team's side
     * @param parameters tell the size of the pitch and the distance between players
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
     * Takes the next place.
     *
     * @return centre of the torso in the world frame, metres
     */
    public Vector3 next() {
        Vector3 place = new Vector3(x, y, radius);
        y -= 3 * radius;
        if (y < -halfWidth) {
            y = halfWidth - 2 * radius;
            x += 2 * radius;
        }
        return place;
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

package org.robonewbie.agent.perception;

import java.util.EnumMap;
import java.util.Map;
import org.robonewbie.agent.log.Diagnostics;
import org.robonewbie.nao.BodyPart;
import org.robonewbie.nao.Vector3;

/**
 * Another robot in the robot's memory. Its position is the mean position of its visible body parts, which are also
 * available separately.
 */
public final class PlayerItem extends FieldItem {

    private final String team;
    private final int number;
    private final boolean teamMate;
    private final Map<BodyPart, FieldItem> parts = new EnumMap<>(BodyPart.class);

    PlayerItem(String team, int number, boolean teamMate, Vision vision, Diagnostics diagnostics) {
        super(team + " " + number, vision, diagnostics);
        this.team = team;
        this.number = number;
        this.teamMate = teamMate;
        for (BodyPart part : BodyPart.values()) {
            parts.put(part, new FieldItem(part + " of " + team + " " + number, vision, diagnostics));
        }
    }

    @Override
    Direction calculatedDirection() {
        Vector3 sum = Vector3.ZERO;
        int count = 0;
        for (FieldItem part : parts.values()) {
            if (part.lastSeenSeconds() == lastSeenSeconds()) {
                sum = sum.plus(part.position());
                count++;
            }
        }
        return count == 0
                ? super.calculatedDirection()
                : Direction.of(new Vector3(sum.x() / count, sum.y() / count, sum.z() / count));
    }

    /** {@return the name of the other robot's team} */
    public String team() {
        return team;
    }

    /** {@return the other robot's player number, 1 to 11; 0 if it has none yet} */
    public int number() {
        return number;
    }

    /** {@return whether the other robot plays for the same team as this robot} */
    public boolean isTeamMate() {
        return teamMate;
    }

    /**
     * Returns a part of the other robot's body.
     *
     * @param part the part
     * @return the part, whether or not it has been seen
     */
    @SuppressWarnings("NullAway") // the map contains every part
    public FieldItem part(BodyPart part) {
        return parts.get(part);
    }
}

package org.robonewbie.agent.perception;

import java.util.EnumMap;
import java.util.Map;
import org.robonewbie.agent.log.Diagnostics;
import org.robonewbie.nao.BodyPart;
import org.robonewbie.nao.Vector3;

/**
 * Another robot as this robot remembers it. It is where the middle of its visible parts was; each part can be asked as well.
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
        double x = 0;
        double y = 0;
        double z = 0;
        int count = 0;
        for (FieldItem part : parts.values()) {
            if (part.lastSeenSeconds() == lastSeenSeconds()) {
                Vector3 place = part.position();
                x += place.x();
                y += place.y();
                z += place.z();
                count++;
            }
        }
        return count == 0 ? super.calculatedDirection() : Direction.of(new Vector3(x / count, y / count, z / count));
    }

    /** {@return the name of the robot's team} */
    public String team() {
        return team;
    }

    /** {@return the number on the robot's shirt, 1 to 11; 0 if it has none yet} */
    public int number() {
        return number;
    }

    /** {@return whether the robot plays for the same team} */
    public boolean isTeamMate() {
        return teamMate;
    }

    /**
     * Returns one part of the robot's body.
     *
     * @param part which part
     * @return the part, known or not
     */
    @SuppressWarnings("NullAway") // the map has each part
    public FieldItem part(BodyPart part) {
        return parts.get(part);
    }
}

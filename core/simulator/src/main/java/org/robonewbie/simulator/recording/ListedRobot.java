package org.robonewbie.simulator.recording;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.TeamSide;

/**
 * A robot in the roster of a recording.
 *
 * @param id id of the robot
 * @param type index of its type: 0 to 4 for the NAOs, more for the models that the recording defines
 * @param side 0 if it has no team, 1 for the left team, 2 for the right team
 * @param number uniform number, 0 if it has no team
 * @param team name of its team, empty if it has no team
 */
public record ListedRobot(int id, int type, int side, int number, String team) {

    /** Reads a record of kind {@link RecordingFormat#ROBOTS}, given the number of types that are defined. */
    static List<ListedRobot> readAll(RecordCursor content, int types) {
        List<ListedRobot> robots = new ArrayList<>();
        for (long count = content.getUnsigned(); count > 0; count--) {
            int id = (int) content.getUnsigned();
            int type = content.getIndex(types);
            int side = content.getIndex(TeamSide.values().length + 1);
            robots.add(new ListedRobot(id, type, side, (int) content.getUnsigned(), content.getText()));
        }
        return List.copyOf(robots);
    }

    /** {@return the type's name on pages, such as {@code TYPE_0}} */
    public String typeName() {
        return "TYPE_" + type;
    }

    Optional<TeamSide> teamSide() {
        return side == 0 ? Optional.empty() : Optional.of(TeamSide.values()[side - 1]);
    }
}

package org.robonewbie.simulator.recording;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.model.RobotType;

/**
 * A robot in the roster of a recording.
 *
 * @param id id of the robot
 * @param type the robot type
 * @param side 0 if it has no team, 1 for the left team, 2 for the right team
 * @param number uniform number, 0 if it has no team
 * @param team name of its team, empty if it has no team
 */
public record ListedRobot(int id, RobotType type, int side, int number, String team) {

    /** Reads a record of kind {@link RecordingFormat#ROBOTS}. */
    static List<ListedRobot> readAll(RecordCursor content) {
        List<ListedRobot> robots = new ArrayList<>();
        for (long count = content.getUnsigned(); count > 0; count--) {
            int id = (int) content.getUnsigned();
            RobotType type = RobotType.values()[content.getIndex(RobotType.values().length)];
            int side = content.getIndex(TeamSide.values().length + 1);
            robots.add(new ListedRobot(id, type, side, (int) content.getUnsigned(), content.getText()));
        }
        return List.copyOf(robots);
    }

    Optional<TeamSide> teamSide() {
        return side == 0 ? Optional.empty() : Optional.of(TeamSide.values()[side - 1]);
    }
}

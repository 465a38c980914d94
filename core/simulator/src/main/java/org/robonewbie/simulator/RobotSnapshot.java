package org.robonewbie.simulator;

import java.util.Optional;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.model.RobotType;

/**
 * The true state of one robot at the end of one cycle.
 *
 * @param id id of the robot's connection, unique while the simulator runs
 * @param team name of its team, empty before it joins one
 * @param side the side its team plays on, empty before it joins a team
 * @param number uniform number 1 to 11, 0 before it joins a team
 * @param body pose of the torso and joint angles
 */
public record RobotSnapshot(int id, String team, Optional<TeamSide> side, int number, BodyState body) {

    /** {@return the robot type} */
    public RobotType type() {
        return body.type();
    }
}

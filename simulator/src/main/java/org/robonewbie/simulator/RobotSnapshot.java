package org.robonewbie.simulator;

import java.util.Optional;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.model.RobotType;

/**
 * The true state of one robot at the end of one cycle.
 *
 * @param id number of the robot's connection, unique while the simulator runs
 * @param team name of its team, empty before it joined one
 * @param side its half of the pitch, empty before it joined a team
 * @param number its number 1 to 11, 0 before it joined a team
 * @param type its build
 * @param linkPoses position x, y, z in metres and rotation as quaternion w, x, y, z of each link of {@code
 *     NaoModel.of(type).links()} in the world frame, seven numbers per link; not to be changed
 * @param jointDegrees angle of each hinge of {@code NaoModel.of(type).hinges()}; not to be changed
 */
@SuppressWarnings("ArrayRecordComponent")
public record RobotSnapshot(
        int id,
        String team,
        Optional<TeamSide> side,
        int number,
        RobotType type,
        float[] linkPoses,
        float[] jointDegrees) {}

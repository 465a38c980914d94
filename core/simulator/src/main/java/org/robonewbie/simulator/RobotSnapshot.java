package org.robonewbie.simulator;

import java.util.Optional;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.robot.RobotState;

/**
 * The true state of one robot at the end of one cycle. Robots of this framework's simulator are NAOs; a watched or recorded match may
 * have others.
 *
 * @param id id of the robot's connection, unique while the simulator runs
 * @param team name of its team, empty before it joins one
 * @param side the side its team plays on, empty before it joins a team
 * @param number uniform number 1 to 11, 0 before it joins a team
 * @param state pose of the torso and joint angles
 */
public record RobotSnapshot(int id, String team, Optional<TeamSide> side, int number, RobotState state) {

    /**
     * Creates the state of a NAO.
     *
     * @param id id of the robot's connection, unique while the simulator runs
     * @param team name of its team, empty before it joins one
     * @param side the side its team plays on, empty before it joins a team
     * @param number uniform number 1 to 11, 0 before it joins a team
     * @param body pose of the torso and joint angles
     */
    public RobotSnapshot(int id, String team, Optional<TeamSide> side, int number, BodyState body) {
        this(id, team, side, number, new RobotState.OfNao(body));
    }

    /** {@return the state of a NAO; empty for another robot} */
    public Optional<BodyState> nao() {
        return state instanceof RobotState.OfNao nao ? Optional.of(nao.body()) : Optional.empty();
    }

    /**
     * Returns the state of a NAO.
     *
     * @return pose of the torso and joint angles
     * @throws IllegalStateException if the robot is not a NAO
     */
    public BodyState body() {
        if (state instanceof RobotState.OfNao nao) {
            return nao.body();
        }
        throw new IllegalStateException("Robot " + number + " of team " + team + " is a "
                + state.model().name() + ". Only a NAO can be used here.");
    }

    /**
     * Returns the type of a NAO.
     *
     * @return the robot type
     * @throws IllegalStateException if the robot is not a NAO
     */
    public RobotType type() {
        return body().type();
    }
}

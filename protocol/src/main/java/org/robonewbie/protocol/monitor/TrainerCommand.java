package org.robonewbie.protocol.monitor;

import java.util.Optional;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;

/**
 * What a monitor, or a trainer behind a monitor connection, can ask a SimSpark server for. Nothing is acknowledged.
 *
 * <p>Positions are metres in the world frame, with the centre spot as origin and x towards the right goal.
 */
public sealed interface TrainerCommand {

    /**
     * Starts a kick-off in any play mode.
     *
     * @param side the team that begins; empty decides by the rules
     */
    record KickOff(Optional<TeamSide> side) implements TrainerCommand {}

    /**
     * Changes the play mode.
     *
     * @param playMode the new play mode
     */
    record ChangePlayMode(PlayMode playMode) implements TrainerCommand {}

    /** Gives the ball free where it lies. */
    record DropBall() implements TrainerCommand {}

    /**
     * Moves the ball.
     *
     * @param position new place of its centre in metres; empty leaves it where it is
     * @param velocity new speed in metres per second, which also stops its spin; empty keeps its motion
     */
    record MoveBall(Optional<Vector3> position, Optional<Vector3> velocity) implements TrainerCommand {}

    /**
     * Moves a robot that keeps its posture and direction.
     *
     * @param player which robot
     * @param position new place of the torso's centre in metres
     */
    record MoveRobot(PlayerNumber player, Vector3 position) implements TrainerCommand {}

    /**
     * Moves a robot and puts it upright.
     *
     * @param player which robot
     * @param position new place of the torso's centre in metres
     * @param degreesFromY direction to look to, counter-clockwise from the y axis: -90 looks along x
     */
    record MoveAndTurnRobot(PlayerNumber player, Vector3 position, double degreesFromY) implements TrainerCommand {}

    /** Moves the selected robot away from where it stands, towards its own goal line. */
    record RepelSelectedRobot() implements TrainerCommand {}

    /**
     * Selects one robot and marks it in the picture.
     *
     * @param player which robot
     */
    record SelectRobot(PlayerNumber player) implements TrainerCommand {}

    /** Selects the next robot in turn. */
    record SelectNextRobot() implements TrainerCommand {}

    /** Selects no robot any more. */
    record SelectNoRobot() implements TrainerCommand {}

    /**
     * Takes a robot off the field for good; its agent stays connected.
     *
     * @param player which robot; empty takes the selected one
     */
    record KillRobot(Optional<PlayerNumber> player) implements TrainerCommand {}

    /**
     * Puts a robot beside the field.
     *
     * @param player which robot; empty takes the selected one
     */
    record RepositionRobot(Optional<PlayerNumber> player) implements TrainerCommand {}

    /** Ends the server. */
    record EndSimulation() implements TrainerCommand {}

    /** Asks for the whole scene in the next message instead of its changes. */
    record RequestFullState() implements TrainerCommand {}

    /**
     * Sets the clock of the game.
     *
     * @param seconds the new game time, at least 0
     */
    record SetTime(double seconds) implements TrainerCommand {}

    /**
     * Sets the score.
     *
     * @param left goals of the left team, at least 0
     * @param right goals of the right team, at least 0
     */
    record SetScore(int left, int right) implements TrainerCommand {}
}

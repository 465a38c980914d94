package org.robonewbie.protocol.order;

import java.util.Optional;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;

/**
 * An order to the world from outside, by a trainer, a person at the studio or a referee's program: it takes effect between two
 * cycles and is not acknowledged.
 *
 * <pre>{@code
 * simulation.order(new Order.MoveBall(new Vector3(1, 0, 0.042), Vector3.ZERO));
 * simulation.order(new Order.KickOff(TeamSide.LEFT));
 * }</pre>
 *
 * <p>Every SimSpark server understands the orders of a {@link Trainer}; the others are those of this simulator. Positions are
 * metres in the world frame, with the centre spot as origin and x towards the right goal.
 */
public sealed interface Order {

    /** An order of SimSpark's trainer protocol, which travels through a monitor port. */
    sealed interface Trainer extends Order {}

    /** An order to the clock of the world. */
    sealed interface Clock extends Order {}

    /**
     * Starts a kick-off in any play mode.
     *
     * @param side the team that kicks off; empty decides by the rules
     */
    record KickOff(Optional<TeamSide> side) implements Trainer {

        /**
         * Creates the order for a given team.
         *
         * @param side the team that kicks off
         */
        public KickOff(TeamSide side) {
            this(Optional.of(side));
        }
    }

    /**
     * Changes the play mode.
     *
     * @param playMode the new play mode
     */
    record ChangePlayMode(PlayMode playMode) implements Trainer {}

    /** Drops the ball where it lies: both teams may play it. */
    record DropBall() implements Trainer {}

    /**
     * Moves the ball.
     *
     * @param position new position of its centre in metres; empty leaves it where it is
     * @param velocity new velocity in metres per second, which also stops its spin; empty keeps its motion
     */
    record MoveBall(Optional<Vector3> position, Optional<Vector3> velocity) implements Trainer {

        /**
         * Creates the order with both position and velocity.
         *
         * @param position new position of the centre in metres
         * @param velocity new velocity in metres per second
         */
        public MoveBall(Vector3 position, Vector3 velocity) {
            this(Optional.of(position), Optional.of(velocity));
        }
    }

    /**
     * Moves a robot, which keeps its posture and heading.
     *
     * @param player the robot
     * @param position new position of the torso's centre in metres
     */
    record MoveRobot(PlayerNumber player, Vector3 position) implements Trainer {}

    /**
     * Moves a robot upright, without waking it.
     *
     * @param player the robot
     * @param position new position of the torso's centre in metres
     * @param degreesFromY its heading, counter-clockwise from the y axis: -90 looks along x
     */
    record MoveAndTurnRobot(PlayerNumber player, Vector3 position, double degreesFromY) implements Trainer {}

    /** Moves the selected robot from where it stands towards its own goal line. */
    record RepelSelectedRobot() implements Trainer {}

    /**
     * Selects one robot and marks it in the picture.
     *
     * @param player the robot
     */
    record SelectRobot(PlayerNumber player) implements Trainer {}

    /** Selects the next robot in turn. */
    record SelectNextRobot() implements Trainer {}

    /** Clears the selection. */
    record SelectNoRobot() implements Trainer {}

    /**
     * Removes a robot from the field for good; its agent stays connected.
     *
     * @param player the robot; empty takes the selected one
     */
    record KillRobot(Optional<PlayerNumber> player) implements Trainer {}

    /**
     * Places a robot beside the field.
     *
     * @param player the robot; empty takes the selected one
     */
    record RepositionRobot(Optional<PlayerNumber> player) implements Trainer {}

    /** Ends the server. */
    record EndSimulation() implements Trainer {}

    /** Requests the whole scene in the next message instead of its changes. */
    record RequestFullState() implements Trainer {}

    /**
     * Sets the clock of the game.
     *
     * @param seconds the new game time, at least 0
     */
    record SetTime(double seconds) implements Trainer {}

    /**
     * Sets the score.
     *
     * @param left goals of the left team, at least 0
     * @param right goals of the right team, at least 0
     */
    record SetScore(int left, int right) implements Trainer {}

    /** Resets ball, robots and score to the start of the game; the agents stay connected. */
    record Reset() implements Order {}

    /**
     * Places a robot, upright and awake, with its joints as they are.
     *
     * @param player the robot
     * @param position new position of the torso's centre in metres
     * @param headingDegrees its heading, 0 along x towards the right goal, counter-clockwise
     */
    record PlaceRobot(PlayerNumber player, Vector3 position, double headingDegrees) implements Order {}

    /**
     * Pushes a robot at the centre of its torso during one cycle, as a hand would.
     *
     * @param player the robot
     * @param newtons the force in the world frame, limited to 1000 N
     */
    record PushRobot(PlayerNumber player, Vector3 newtons) implements Order {}

    /** Stops the clock of the world; agents wait. */
    record Pause() implements Clock {}

    /** Restarts the clock. */
    record Resume() implements Clock {}

    /**
     * Runs some cycles and pauses.
     *
     * @param cycles how many cycles of 20 ms, at least 1
     */
    record Step(int cycles) implements Clock {}

    /**
     * Sets how fast simulated time passes.
     *
     * @param factor simulated seconds per second, from 0.1; infinity does not wait at all
     */
    record SetSpeed(double factor) implements Clock {}
}

package org.robonewbie.protocol.order;

import java.util.Optional;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;

/**
 * A command to the simulated world from a trainer, the studio's user or a referee program. It takes effect between two cycles
 * and is not acknowledged.
 *
 * <pre>{@code
 * simulation.order(new Order.MoveBall(new Vector3(1, 0, 0.042), Vector3.ZERO));
 * simulation.order(new Order.KickOff(TeamSide.LEFT));
 * }</pre>
 *
 * <p>Every SimSpark server supports the commands of type {@link Trainer}; the others are specific to this simulator. Positions are in
 * metres in the world frame, with the origin at the centre spot and x towards the right goal.
 */
public sealed interface Order {

    /** A command of SimSpark's trainer protocol, which is sent to the monitor port. */
    sealed interface Trainer extends Order {}

    /** A command that controls the clock of the simulation. */
    sealed interface Clock extends Order {}

    /**
     * Starts a kick-off, regardless of the current play mode.
     *
     * @param side the team that kicks off; empty for the team determined by the rules
     */
    record KickOff(Optional<TeamSide> side) implements Trainer {

        /**
         * Creates a kick-off command for a team.
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

    /** Drops the ball at its current position, so that both teams may play it. */
    record DropBall() implements Trainer {}

    /**
     * Moves the ball.
     *
     * @param position new position of the ball's centre in metres; empty to keep the position
     * @param velocity new velocity in metres per second, which also stops the spin; empty to keep velocity and spin
     */
    record MoveBall(Optional<Vector3> position, Optional<Vector3> velocity) implements Trainer {

        /**
         * Creates a command with both position and velocity.
         *
         * @param position new position of the ball's centre in metres
         * @param velocity new velocity in metres per second, which also stops the spin
         */
        public MoveBall(Vector3 position, Vector3 velocity) {
            this(Optional.of(position), Optional.of(velocity));
        }
    }

    /**
     * Moves a robot, keeping its posture and heading.
     *
     * @param player the robot
     * @param position new position of the torso's centre in metres
     */
    record MoveRobot(PlayerNumber player, Vector3 position) implements Trainer {}

    /**
     * Moves a robot to an upright pose. Does not wake its bodies if the physics engine has put them to sleep.
     *
     * @param player the robot
     * @param position new position of the torso's centre in metres
     * @param degreesFromY heading in degrees, counter-clockwise from the y axis; -90 faces along x
     */
    record MoveAndTurnRobot(PlayerNumber player, Vector3 position, double degreesFromY) implements Trainer {}

    /** Moves the selected robot from its position towards its own goal line. */
    record RepelSelectedRobot() implements Trainer {}

    /**
     * Selects a robot and highlights it in monitors.
     *
     * @param player the robot
     */
    record SelectRobot(PlayerNumber player) implements Trainer {}

    /** Selects the next robot. */
    record SelectNextRobot() implements Trainer {}

    /** Clears the selection. */
    record SelectNoRobot() implements Trainer {}

    /**
     * Removes a robot from the field for the rest of the game; its agent stays connected.
     *
     * @param player the robot; empty for the selected one
     */
    record KillRobot(Optional<PlayerNumber> player) implements Trainer {}

    /**
     * Moves a robot to a position beside the field.
     *
     * @param player the robot; empty for the selected one
     */
    record RepositionRobot(Optional<PlayerNumber> player) implements Trainer {}

    /** Stops the server. */
    record EndSimulation() implements Trainer {}

    /** Requests that the next message contain the full scene instead of only the changes. */
    record RequestFullState() implements Trainer {}

    /**
     * Sets the game time.
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

    /** Resets the ball, the robots and the score to their state at the start of the game. Agents stay connected. */
    record Reset() implements Order {}

    /**
     * Places a robot upright at a pose, keeping its joint angles. Wakes its bodies if the physics engine has put them to sleep.
     *
     * @param player the robot
     * @param position new position of the torso's centre in metres
     * @param headingDegrees heading in degrees, 0 along x towards the right goal, counter-clockwise
     */
    record PlaceRobot(PlayerNumber player, Vector3 position, double headingDegrees) implements Order {}

    /**
     * Applies a force to the centre of a robot's torso during one cycle.
     *
     * @param player the robot
     * @param newtons force in the world frame in newtons, limited to 1000 N
     */
    record PushRobot(PlayerNumber player, Vector3 newtons) implements Order {}

    /**
     * Scales the friction of all surfaces and the masses of the robots that are in the world.
     *
     * @param friction multiple of SimSpark's friction, above 0
     * @param mass multiple of the mass of each robot's type, above 0
     */
    record SetProperties(double friction, double mass) implements Order {}

    /** Pauses the simulation. Agents receive no messages until it resumes. */
    record Pause() implements Clock {}

    /** Resumes a paused simulation. */
    record Resume() implements Clock {}

    /**
     * Runs the given number of cycles, then pauses.
     *
     * @param cycles number of cycles of 20 ms, at least 1
     */
    record Step(int cycles) implements Clock {}

    /**
     * Sets the speed of the simulation.
     *
     * @param factor simulated seconds per real second, at least 0.1; infinity to run as fast as possible
     */
    record SetSpeed(double factor) implements Clock {}
}

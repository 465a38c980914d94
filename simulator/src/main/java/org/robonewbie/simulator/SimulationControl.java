package org.robonewbie.simulator;

import java.util.Optional;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.frame.AgentLink;

/**
 * Steers a running simulation from any thread; what is asked for takes effect between two cycles.
 */
public interface SimulationControl {

    /** Speed factor for {@link #setSpeed} that means: do not wait between cycles. */
    double AS_FAST_AS_POSSIBLE = Double.POSITIVE_INFINITY;

    /**
     * Tells on which pitch is played.
     *
     * @return the pitch
     */
    SoccerField field();

    /**
     * Tells whether the clock can be stopped and the world be restored.
     *
     * @return false for a world that is only watched, where {@link #pause}, {@link #resume}, {@link #step}, {@link #setSpeed}
     *     and {@link #restore} are not possible
     */
    default boolean hasClock() {
        return true;
    }

    /** Stops the clock of the world; agents wait. */
    void pause();

    /** Lets the clock run again. */
    void resume();

    /**
     * Runs some cycles and pauses.
     *
     * @param cycles how many cycles of 20 ms, at least 1
     */
    void step(int cycles);

    /**
     * Sets how fast simulated time passes.
     *
     * @param factor simulated seconds per second, from 0.1; {@link #AS_FAST_AS_POSSIBLE} does not wait at all
     */
    void setSpeed(double factor);

    /** Puts ball, robots and score back to the start of the game; the agents stay connected. */
    void reset();

    /**
     * Puts the ball somewhere.
     *
     * @param position centre of the ball in the world frame, metres
     * @param velocity its speed in metres per second
     */
    void placeBall(Vector3 position, Vector3 velocity);

    /**
     * Puts a robot somewhere, upright, with its joints as they are.
     *
     * @param side the robot's team
     * @param number its number, 1 to 11
     * @param position new place of the torso's centre in the world frame, metres
     * @param headingDegrees direction to look to, 0 along x towards the right goal, counter-clockwise
     */
    void placeRobot(TeamSide side, int number, Vector3 position, double headingDegrees);

    /**
     * Pushes a robot at the centre of its torso during one cycle, as a hand would. Nothing happens in a world of another
     * program, which only its owner can push.
     *
     * @param side the robot's team
     * @param number its number, 1 to 11
     * @param newtons the force in the world frame; cut to 1000 N
     */
    default void pushRobot(TeamSide side, int number, Vector3 newtons) {}

    /**
     * Lets a team kick off.
     *
     * @param side the team that begins
     */
    void kickOff(TeamSide side);

    /** Gives the ball free where it lies. */
    void dropBall();

    /**
     * Sets any play mode.
     *
     * @param playMode the new play mode
     */
    void setPlayMode(PlayMode playMode);

    /**
     * Lets the world go on from a state that was seen before. Robots of that state that do not play now are left out.
     *
     * @param before an earlier state, from which the velocities are taken; the same state for a world that rests
     * @param moment the state to go on from
     */
    default void restore(WorldSnapshot before, WorldSnapshot moment) {}

    /**
     * Connects an agent of this process, which gets a robot as any other agent does.
     *
     * @return the agent's end of the connection; empty where agents cannot join
     */
    default Optional<AgentLink> connect() {
        return Optional.empty();
    }

    /**
     * Starts to report each cycle.
     *
     * @param observer called on the simulation's own thread
     */
    void addObserver(SimulationObserver observer);

    /**
     * Ends the reports.
     *
     * @param observer the observer
     */
    void removeObserver(SimulationObserver observer);
}

package org.robonewbie.agent.motion;

import java.util.Optional;
import org.robonewbie.nao.motion.Interpolation;
import org.robonewbie.nao.motion.Motion;

/**
 * Plays keyframe motions by name. A motion runs to its end; the next one can start when {@link #isFinished} returns
 * true. A motion begins from the current posture; if necessary, a walking robot stops first, and a standing robot takes
 * a first step before it walks.
 *
 * <pre>{@code
 * if (motions.isFinished()) {
 *     motions.start(ballIsAhead ? "walk-forward" : "turn-left");
 * }
 * }</pre>
 *
 * <p>A motion file declares its start and end states in the comments {@code // start: stance} and {@code // end: stance}; for
 * example, after {@code // end: walking} the robot stops before it turns. A motion without these comments can start
 * when the robot is standing.
 *
 * <p>A fallen robot gets up first if the motion declares a start state in which the robot is on its feet.
 *
 * <p>If the program commands a joint while a motion is running, the joint follows the program until the next motion
 * starts.
 */
public interface Motions {

    /**
     * Starts a motion, unless another one is running.
     *
     * @param name name of the file {@code motions/NAME.txt} in the working directory, or of a shipped motion
     * @return whether the motion starts; false while another one is running or if there is no such motion. A missing
     *     motion is reported. If the file has become invalid since it was last played, this is reported, and the last
     *     valid version is played.
     */
    boolean start(String name);

    /**
     * Starts a motion that the program has created, unless another one is running.
     *
     * @param motion the motion
     * @return whether the motion starts
     */
    boolean start(Motion motion);

    /**
     * Starts the mirror image of a motion, with left and right exchanged.
     *
     * @param name name of the original, as in {@link #start(String)}
     * @return whether the motion starts
     */
    boolean startMirrored(String name);

    /**
     * Starts a motion and repeats it until {@link #stop} is called.
     *
     * @param name name of the motion, as in {@link #start(String)}
     * @return whether the motion starts
     */
    boolean loop(String name);

    /**
     * Starts the motion that makes a fallen robot get up: {@code stand-up-from-back}, {@code stand-up-from-front},
     * {@code stand-up-from-left-side} or {@code stand-up-from-right-side}. If there is no motion for that side, the one
     * for the back is used.
     *
     * @return whether the motion starts; false if the robot is upright or another motion is running
     */
    boolean startGetUp();

    /** Stops the running motion immediately; a walking robot may fall. */
    void stop();

    /**
     * Stops the running motion as {@link #stop} does, and assumes that the robot is standing with straight legs, as
     * after a beam.
     */
    void reset();

    /** {@return whether a new motion can start: the last one is over, or there was none} */
    boolean isFinished();

    /** {@return the name of the running motion; empty if none is running} */
    Optional<String> current();

    /**
     * {@return the one-based number of the keyframe that the robot is approaching; 0 if no motion is running}
     */
    int keyframe();

    /**
     * Sets whether a fallen robot gets up automatically before a motion that requires it to be on its feet; enabled by
     * default.
     *
     * @param on whether a fallen robot gets up; if false, it plays motions while lying on the ground
     */
    void setAutomaticGetUp(boolean on);

    /**
     * Sets the playback speed of motions that start from now on.
     *
     * @param factor 1 for the speed of the file, 2 for twice the speed; must be above 0
     */
    void setSpeed(double factor);

    /**
     * Sets the interpolation between keyframes for motions that start from now on.
     *
     * @param interpolation the interpolation, such as a spline
     */
    void setInterpolation(Interpolation interpolation);
}

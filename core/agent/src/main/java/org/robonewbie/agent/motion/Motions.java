package org.robonewbie.agent.motion;

import java.util.Optional;
import org.robonewbie.nao.motion.Interpolation;
import org.robonewbie.nao.motion.Motion;

/**
 * Plays motions by name, in sequence. A motion that has started runs to its end; another one can start when {@link
 * #isFinished}. It begins from wherever the robot is; where it would begin in the middle of a step, the robot first stops, and
 * before a walk it makes a first step.
 *
 * <pre>{@code
 * if (motions.isFinished()) {
 *     motions.start(ballIsAhead ? "walk-forward" : "turn-left");
 * }
 * }</pre>
 *
 * <p>A file states in the comments {@code // start: stance} and {@code // end: stance} between which postures it leads; from
 * {@code // end: walking} the robot stops before it turns. Without a comment a motion starts when the robot stands.
 *
 * <p>A fallen robot first gets up when a motion starts whose file states that it starts on the feet.
 *
 * <p>A joint that you command while a motion runs is yours until the next motion starts.
 */
public interface Motions {

    /**
     * Starts a motion, unless another one is still running.
     *
     * @param name its file is {@code motions/NAME.txt} in the working directory or comes with the framework
     * @return whether the motion starts; false while another one runs, and with a report if there is no such motion; a file
     *     that was broken since it was last played is reported and played as it was
     */
    boolean start(String name);

    /**
     * Starts a motion that was made by the program, unless another one is still running.
     *
     * @param motion the motion
     * @return whether it starts
     */
    boolean start(Motion motion);

    /**
     * Starts the mirror image of a motion, with left and right exchanged.
     *
     * @param name as in {@link #start(String)}; the file {@code NAME.txt} is played in the mirror
     * @return whether the motion starts
     */
    boolean startMirrored(String name);

    /**
     * Starts a motion that is repeated until {@link #stop} is called.
     *
     * @param name as in {@link #start(String)}
     * @return whether the motion starts
     */
    boolean loop(String name);

    /**
     * Starts the motion that brings a fallen robot to its feet: {@code stand-up-from-back}, {@code stand-up-from-front},
     * {@code stand-up-from-left-side} or {@code stand-up-from-right-side}. Without a motion for the side, that for the back is tried.
     *
     * @return whether it starts; false if the robot is upright or another motion is running
     */
    boolean startGetUp();

    /** Stops the running motion where it is; a walking robot may fall. */
    void stop();

    /** Stops as {@link #stop}, and expects the robot to stand with straight legs next, as after a beam. */
    void reset();

    /** {@return whether a new motion can start: the last one has run to its end, or there was none} */
    boolean isFinished();

    /** {@return the name of the running motion; empty if none is running} */
    Optional<String> current();

    /** {@return the number of the keyframe that the robot approaches, from 1; 0 if no motion is running} */
    int keyframe();

    /**
     * Sets whether a fallen robot gets up by itself before it plays a motion that starts on the feet; at first it does.
     *
     * @param on false lets each motion begin as the robot lies
     */
    void setAutomaticGetUp(boolean on);

    /**
     * Sets how fast motions are played, from the next start on.
     *
     * @param factor 1 as in the file, 2 twice as fast; only numbers above 0 count
     */
    void setSpeed(double factor);

    /**
     * Sets how joints move between keyframes, from the next start on.
     *
     * @param interpolation such as a spline
     */
    void setInterpolation(Interpolation interpolation);
}

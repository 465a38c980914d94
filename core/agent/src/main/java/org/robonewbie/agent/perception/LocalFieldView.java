package org.robonewbie.agent.perception;

import java.util.List;
import org.robonewbie.nao.Landmark;

/**
 * What the robot remembers of the field around it. The camera sees 120° in each third cycle; here everything stays where it
 * was last seen, as a robot that looks straight ahead would see it.
 *
 * <p>The turns of the head are taken into account, by {@link CameraTransformation#SUM_OF_ANGLES} unless another one is chosen.
 * Other movements of the robot since the last sighting are not: the older a sighting ({@link FieldItem#ageSeconds}), the less it is
 * worth.
 *
 * <pre>{@code
 * if (fieldView.ball().isVisible() && fieldView.ball().distance() < 0.5) { ... }
 * }</pre>
 *
 * <p>Left and right posts are those that a player sees who looks at that goal from the field.
 */
public interface LocalFieldView {

    /** {@return the ball, known or not} */
    FieldItem ball();

    /**
     * Returns a goal post or flag by its name on the pitch.
     *
     * @param landmark which one
     * @return the landmark, known or not
     */
    FieldItem landmark(Landmark landmark);

    /** {@return the top of the left post of the opponents' goal, known or not} */
    FieldItem opponentGoalLeftPost();

    /** {@return the top of the right post of the opponents' goal, known or not} */
    FieldItem opponentGoalRightPost();

    /** {@return the top of the left post of the goal that the robot's team defends, known or not} */
    FieldItem ownGoalLeftPost();

    /** {@return the top of the right post of the goal that the robot's team defends, known or not} */
    FieldItem ownGoalRightPost();

    /** {@return all other robots that were seen within the last 10 seconds, in the order in which they were first seen} */
    List<PlayerItem> players();

    /** {@return the robots of the same team that were seen within the last 10 seconds, without this robot} */
    List<PlayerItem> teamMates();

    /** {@return the robots of the other team that were seen within the last 10 seconds} */
    List<PlayerItem> opponents();

    /** {@return the pieces of field lines in the last picture; empty if the camera has not seen anything for 0.1 s} */
    List<LineItem> lines();

    /**
     * Sets how the turned head is taken into account.
     *
     * @param transformation such as {@link CameraTransformation#KINEMATICS}
     */
    void setTransformation(CameraTransformation transformation);
}

package org.robonewbie.agent.perception;

import java.util.List;
import org.robonewbie.nao.FieldMarking;
import org.robonewbie.nao.Landmark;

/**
 * The robot's memory of the field around it. The camera covers 120° and takes a picture in every third cycle; each
 * object keeps the position of its last sighting, converted to the view of a robot looking straight ahead.
 *
 * <p>Head rotations are compensated, by {@link CameraTransformation#SUM_OF_ANGLES} unless another transformation is set. Other
 * movements of the robot since the last sighting are not: the higher {@link FieldItem#ageSeconds}, the less reliable the
 * position.
 *
 * <pre>{@code
 * if (fieldView.ball().isVisible() && fieldView.ball().distance() < 0.5) { ... }
 * }</pre>
 *
 * <p>Left and right posts are named as seen by a player facing the goal from the field.
 */
public interface LocalFieldView {

    /** {@return the ball, whether or not it has been seen} */
    FieldItem ball();

    /**
     * Returns a goal post or flag.
     *
     * @param landmark name of the landmark
     * @return the landmark, whether or not it has been seen
     */
    FieldItem landmark(Landmark landmark);

    /**
     * Returns a point of the field lines. Only the cameras of today's league recognise them, such as that of a T1.
     *
     * @param marking the point
     * @return the point, whether or not it has been seen
     * @throws UnsupportedOperationException if this field view has no markings
     */
    default FieldItem marking(FieldMarking marking) {
        throw new UnsupportedOperationException("This field view has no markings.");
    }

    /** {@return the top of the left post of the opponents' goal, whether or not it has been seen} */
    FieldItem opponentGoalLeftPost();

    /** {@return the top of the right post of the opponents' goal, whether or not it has been seen} */
    FieldItem opponentGoalRightPost();

    /** {@return the top of the left post of the goal that the robot's team defends, whether or not it has been seen} */
    FieldItem ownGoalLeftPost();

    /** {@return the top of the right post of the goal that the robot's team defends, whether or not it has been seen} */
    FieldItem ownGoalRightPost();

    /** {@return all other robots that were seen within the last 10 seconds, in the order of their first sighting} */
    List<PlayerItem> players();

    /** {@return the robots of the same team that were seen within the last 10 seconds, excluding this robot} */
    List<PlayerItem> teamMates();

    /** {@return the robots of the other team that were seen within the last 10 seconds} */
    List<PlayerItem> opponents();

    /** {@return the segments of field lines in the last picture; empty if it is older than 0.1 s} */
    List<LineItem> lines();

    /**
     * Sets how head rotations are compensated.
     *
     * @param transformation the transformation, such as {@link CameraTransformation#KINEMATICS}
     */
    void setTransformation(CameraTransformation transformation);
}

package org.robonewbie.robot;

import java.util.List;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Pose;

/**
 * A rigid body of a robot.
 *
 * @param name name of the body, unique within the robot
 * @param parent index of the inner body; {@link #NO_PARENT} for the torso
 * @param pose the body's frame relative to its parent's frame while the joint between them is at 0°; for the torso, the identity
 * @param massKg mass in kilograms
 * @param inertialPose centre of mass and directions of the principal axes in the body's frame
 * @param inertia principal moments of inertia about the centre of mass in kg m²
 * @param shapes solid shapes of the body; may be empty
 */
public record RobotBody(
        String name,
        int parent,
        Pose pose,
        double massKg,
        Pose inertialPose,
        Vector3 inertia,
        List<PlacedShape> shapes) {

    /** The parent's index of a body that has none. */
    public static final int NO_PARENT = -1;

    /** Copies the list of shapes. */
    public RobotBody {
        shapes = List.copyOf(shapes);
    }
}

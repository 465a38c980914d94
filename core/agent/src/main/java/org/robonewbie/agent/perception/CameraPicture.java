package org.robonewbie.agent.perception;

import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.Vector3;

/**
 * The objects in a single camera picture. Directions are relative to the pose of the head at the time of the picture.
 *
 * @param sightings the recognised objects
 * @param truth the true positions, which only a simulator with the option {@code --truth} sends
 */
public record CameraPicture(List<Sighting> sightings, Optional<Truth> truth) {

    public CameraPicture {
        sightings = List.copyOf(sightings);
    }

    /**
     * A recognised object.
     *
     * @param name name of the object, such as {@code ball}, {@code GOAL_POST_1_LEFT}, {@code Blue 3 HEAD} or
     *     {@code end of a line}
     * @param direction direction in which it is seen
     */
    public record Sighting(String name, Direction direction) {}

    /**
     * True positions in the frame of the robot's team: x towards the opponents' goal, y to the left, the origin at the
     * centre of the field.
     *
     * @param head position of the centre of the robot's head, in metres
     * @param headDegrees heading of the head; 0 is towards the opponents' goal, positive is left
     * @param ball position of the centre of the ball, in metres
     */
    public record Truth(Vector3 head, double headDegrees, Vector3 ball) {}
}

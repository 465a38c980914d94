package org.robonewbie.agent.perception;

import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.Vector3;

/**
 * One picture of the camera, without any memory. Directions are relative to the head as it is turned now.
 *
 * @param sightings what the camera recognises
 * @param truth the true positions, which only a simulator with the option {@code --truth} sends
 */
public record CameraPicture(List<Sighting> sightings, Optional<Truth> truth) {

    /** Makes the list unmodifiable. */
    public CameraPicture {
        sightings = List.copyOf(sightings);
    }

    /**
     * Something that the camera recognises.
     *
     * @param name such as {@code ball}, {@code GOAL_POST_1_LEFT}, {@code Blue 3 HEAD} or {@code end of a line}
     * @param direction where it is seen
     */
    public record Sighting(String name, Direction direction) {}

    /**
     * True places in the frame of the robot's team: x towards the opponents' goal, y to the left, the origin in the centre spot.
     *
     * @param head the centre of the robot's head, in metres
     * @param headDegrees where the head looks; 0 is towards the opponents' goal, positive is left
     * @param ball the centre of the ball, in metres
     */
    public record Truth(Vector3 head, double headDegrees, Vector3 ball) {}
}

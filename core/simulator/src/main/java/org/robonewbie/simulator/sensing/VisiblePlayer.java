package org.robonewbie.simulator.sensing;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.BodyPart;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.world.Robot;

/**
 * Snapshot of a player, shared by all cameras that take an image in the same cycle.
 *
 * @param team team name
 * @param number shirt number
 * @param parts positions of the body parts in the world frame in metres, in the order of {@link BodyPart}
 */
public record VisiblePlayer(String team, int number, List<Vector3> parts) {

    private static final BodyPart[] PARTS = BodyPart.values();

    /**
     * Takes a snapshot of a robot.
     *
     * @param robot the robot
     * @param team team name
     * @param number shirt number
     */
    public VisiblePlayer(Robot robot, String team, int number) {
        this(team, number, positions(robot));
    }

    private static List<Vector3> positions(Robot robot) {
        List<Vector3> positions = new ArrayList<>(PARTS.length);
        for (BodyPart part : PARTS) {
            positions.add(robot.linkPosition(robot.nao().linkIndex(part.simSparkName())));
        }
        return positions;
    }
}

package org.robonewbie.simulator.sensing;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.BodyPart;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.world.Robot;

/**
 * A robot that belongs to a team and can be recognised by its shirt, as it is at the moment of a picture; all cameras that take
 * one at this moment share it.
 *
 * @param team name of its team
 * @param number number on its shirt
 * @param parts where its body parts are in the world frame, metres, in the order of {@link BodyPart}
 */
public record VisiblePlayer(String team, int number, List<Vector3> parts) {

    private static final BodyPart[] PARTS = BodyPart.values();

    /**
     * Looks where the parts of a robot are now.
     *
     * @param robot its body
     * @param team name of its team
     * @param number number on its shirt
     */
    public VisiblePlayer(Robot robot, String team, int number) {
        this(team, number, places(robot));
    }

    private static List<Vector3> places(Robot robot) {
        List<Vector3> places = new ArrayList<>(PARTS.length);
        for (BodyPart part : PARTS) {
            places.add(robot.linkPosition(robot.model().linkIndex(part.simSparkName())));
        }
        return places;
    }
}

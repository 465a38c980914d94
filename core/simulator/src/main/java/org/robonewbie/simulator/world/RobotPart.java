package org.robonewbie.simulator.world;

/**
 * One link of one robot, as it appears in reports of contacts.
 *
 * @param robot the robot
 * @param link index of the link in {@code robot.model().links()}
 */
public record RobotPart(Robot robot, int link) {

    /** {@return SimSpark's name of the link, such as {@code rfoot}} */
    public String name() {
        return robot.model().links().get(link).name();
    }
}

package org.robonewbie.simulator.world;

/**
 * Link of a robot, as reported in contacts.
 *
 * @param robot the robot
 * @param link index of the link in {@code robot.model().bodies()}
 */
public record RobotPart(Robot robot, int link) {

    /** {@return the name of the link, such as {@code rfoot}} */
    public String name() {
        return robot.model().bodies().get(link).name();
    }
}

package org.robonewbie.simulator.monitor;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.world.Robot;

/**
 * What monitors receive about one robot.
 *
 * @param id number of its connection, unique while the simulator runs
 * @param type its robot type
 * @param player its team and number, empty before it joined a team
 * @param selected whether a trainer has selected it
 * @param places 16 numbers for each link as in a scene's transform, in the order of the robot's links; not to be changed
 */
@SuppressWarnings("ArrayRecordComponent")
public record MonitoredRobotState(
        int id, RobotType type, Optional<PlayerNumber> player, boolean selected, float[] places) {

    private static final int PLACE_SIZE = 16;

    /**
     * Copies what monitors need from a robot of the world.
     *
     * @param id number of its connection
     * @param robot the robot
     * @param player its team and number, empty before it joined a team
     * @param selected whether a trainer has selected it
     * @return its present state
     */
    public static MonitoredRobotState of(int id, Robot robot, Optional<PlayerNumber> player, boolean selected) {
        List<BodyPose> links = IntStream.range(0, robot.model().links().size())
                .mapToObj(robot::linkPose)
                .toList();
        return of(id, robot.model().type(), links, player, selected);
    }

    /** What monitors need from a robot whose links have these poses. */
    static MonitoredRobotState of(
            int id, RobotType type, List<BodyPose> links, Optional<PlayerNumber> player, boolean selected) {
        float[] places = new float[PLACE_SIZE * links.size()];
        for (int i = 0; i < links.size(); i++) {
            writePlace(links.get(i), places, PLACE_SIZE * i);
        }
        return new MonitoredRobotState(id, type, player, selected, places);
    }

    /**
     * Writes a pose as a scene's transform has it.
     *
     * @param pose the pose
     * @param target takes 16 numbers
     * @param offset index of the first of them
     */
    static void writePlace(BodyPose pose, float[] target, int offset) {
        writeColumn(pose.rotation().axisX(), target, offset);
        writeColumn(pose.rotation().axisY(), target, offset + 4);
        writeColumn(pose.rotation().axisZ(), target, offset + 8);
        writeColumn(pose.position(), target, offset + 12);
        target[offset + 15] = 1;
    }

    private static void writeColumn(Vector3 column, float[] target, int offset) {
        target[offset] = (float) column.x();
        target[offset + 1] = (float) column.y();
        target[offset + 2] = (float) column.z();
    }
}

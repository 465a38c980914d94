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
 * The state of one robot, as sent to monitors.
 *
 * @param id id of the robot, unique while the simulator runs
 * @param type the robot type
 * @param player team and number of the robot, empty before it joins a team
 * @param selected whether a trainer has selected it
 * @param transforms transforms of the links, 4 × 4 matrices in column-major order; must not be modified
 */
@SuppressWarnings("ArrayRecordComponent")
public record MonitoredRobotState(
        int id, RobotType type, Optional<PlayerNumber> player, boolean selected, float[] transforms) {

    static final int TRANSFORM_SIZE = 16;

    /**
     * Takes a snapshot of a robot.
     *
     * @param id id of the robot
     * @param robot the robot
     * @param player team and number of the robot, empty before it joins a team
     * @param selected whether a trainer has selected it
     * @return its current state
     */
    public static MonitoredRobotState of(int id, Robot robot, Optional<PlayerNumber> player, boolean selected) {
        List<BodyPose> links = IntStream.range(0, robot.nao().links().size())
                .mapToObj(robot::linkPose)
                .toList();
        return of(id, robot.type(), links, player, selected);
    }

    static MonitoredRobotState of(
            int id, RobotType type, List<BodyPose> links, Optional<PlayerNumber> player, boolean selected) {
        float[] transforms = new float[TRANSFORM_SIZE * links.size()];
        for (int i = 0; i < links.size(); i++) {
            writeTransform(links.get(i), transforms, TRANSFORM_SIZE * i);
        }
        return new MonitoredRobotState(id, type, player, selected, transforms);
    }

    static float[] transform(BodyPose pose) {
        float[] transform = new float[TRANSFORM_SIZE];
        writeTransform(pose, transform, 0);
        return transform;
    }

    /** Writes a pose as a 4 × 4 matrix in column-major order to the 16 elements starting at {@code offset}. */
    private static void writeTransform(BodyPose pose, float[] target, int offset) {
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

package org.robonewbie.studio;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.kinematics.SimSparkFrame;
import org.robonewbie.robot.RobotState;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.WorldSnapshot;

/**
 * Binary wire format of the world's state, little-endian.
 *
 * <p>Each robot takes 64 bytes: only the torso's pose and the joint angles are sent, and the page computes the other limbs by
 * forward kinematics. 22 robots at 25 frames per second take 36 KB per second.
 *
 * <pre>
 * header   u8 version, u8 flags (1 = paused), u16 scene revision, u32 cycle,
 *          f32 game time, f32 requested speed, f32 real-time factor,
 *          u8 play mode, u8 score left, u8 score right, u8 half
 * ball     3 × f32 position, 4 × i16 rotation w, x, y, z (1 = 32767)
 * robots   each 3 × f32 torso position, 4 × i16 torso rotation, then i16 per hinge in 1/100 degree
 * things   each 3 × f32 position, 4 × i16 rotation
 * </pre>
 */
final class StateFrame {

    /** First byte of every frame. A page that expects a different version prompts the user to reload it. */
    static final int VERSION = 1;

    private static final int HEADER_BYTES = 24;
    private static final int POSE_BYTES = 20;
    private static final int UNIT_ROTATION = Short.MAX_VALUE;
    private static final float STEPS_PER_DEGREE = 100;

    private StateFrame() {}

    /**
     * Encodes a state.
     *
     * @param snapshot the state of the world
     * @param sceneRevision revision of the scene that describes the robots
     * @return the frame, ready to be read
     */
    static ByteBuffer write(WorldSnapshot snapshot, int sceneRevision) {
        ByteBuffer buffer = ByteBuffer.allocate(size(snapshot)).order(ByteOrder.LITTLE_ENDIAN);
        buffer.put((byte) VERSION).put((byte) (snapshot.paused() ? 1 : 0)).putShort((short) sceneRevision);
        buffer.putInt((int) snapshot.cycle());
        buffer.putFloat((float) snapshot.gameTime());
        buffer.putFloat((float) snapshot.speed());
        buffer.putFloat((float) snapshot.realTimeFactor());
        buffer.put((byte) snapshot.playMode().ordinal());
        buffer.put((byte) snapshot.scoreLeft())
                .put((byte) snapshot.scoreRight())
                .put((byte) snapshot.half());
        putPosition(buffer, snapshot.ballPosition());
        putRotation(buffer, snapshot.ballRotation());
        snapshot.robots().forEach(robot -> putRobot(buffer, robot));
        snapshot.things().forEach(thing -> putPose(buffer, thing.pose()));
        return buffer.flip().asReadOnlyBuffer();
    }

    private static int size(WorldSnapshot snapshot) {
        int size = HEADER_BYTES + POSE_BYTES * (1 + snapshot.things().size());
        for (RobotSnapshot robot : snapshot.robots()) {
            size += POSE_BYTES + Short.BYTES * robot.state().joints();
        }
        return size;
    }

    private static void putRobot(ByteBuffer buffer, RobotSnapshot robot) {
        RobotState state = robot.state();
        putPose(buffer, SimSparkFrame.linkFromBody(state.torso()));
        for (int joint = 0; joint < state.joints(); joint++) {
            buffer.putShort(clamped((float) state.degrees(joint) * STEPS_PER_DEGREE));
        }
    }

    private static void putPose(ByteBuffer buffer, Pose pose) {
        putPosition(buffer, pose.position());
        putRotation(buffer, pose.rotation());
    }

    private static void putPosition(ByteBuffer buffer, Vector3 position) {
        buffer.putFloat((float) position.x()).putFloat((float) position.y()).putFloat((float) position.z());
    }

    private static void putRotation(ByteBuffer buffer, Rotation turn) {
        for (double part : new double[] {turn.w(), turn.x(), turn.y(), turn.z()}) {
            buffer.putShort(clamped((float) part * UNIT_ROTATION));
        }
    }

    private static short clamped(float value) {
        return (short) Math.max(Short.MIN_VALUE, Math.min(Short.MAX_VALUE, Math.round(value)));
    }
}

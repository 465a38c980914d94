package org.robonewbie.learning.environment;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.kinematics.SimSparkFrame;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.protocol.perceptor.FootForce;
import org.robonewbie.protocol.perceptor.FootForces;
import org.robonewbie.robot.RobotJoint;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.physics.RotationMatrix;
import org.robonewbie.simulator.world.Ball;
import org.robonewbie.simulator.world.LinkMotion;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.trial.ExternalPhysics;

/** Physics of an episode, computed by the client; docs/gym-protocol.md describes the messages. */
final class ClientPhysics implements ExternalPhysics {

    private final int environment;
    private final Function<byte[], ByteBuffer> client;
    private boolean begun;

    ClientPhysics(int environment, Function<byte[], ByteBuffer> client) {
        this.environment = environment;
        this.client = client;
    }

    @Override
    public void advance(Robot robot, Ball ball, double... radiansPerSecond) {
        ByteBuffer answer = client.apply(state(robot, ball, radiansPerSecond));
        begun = true;
        List<LinkMotion> motions = new ArrayList<>();
        for (int i = 0; i < robot.model().bodies().size(); i++) {
            motions.add(motion(answer));
        }
        robot.place(motions);
        ball.place(
                new LinkMotion(new BodyPose(vector(answer), RotationMatrix.IDENTITY), vector(answer), vector(answer)));
        robot.setFootForces(new FootForces(foot(answer), foot(answer), foot(answer), foot(answer)));
    }

    private byte[] state(Robot robot, Ball ball, double... radiansPerSecond) {
        List<RobotJoint> joints = robot.model().joints();
        ByteBuffer state =
                ByteBuffer.allocate(Double.BYTES * (31 + 3 * joints.size())).order(ByteOrder.LITTLE_ENDIAN);
        state.putDouble(environment).putDouble(robot.type().ordinal()).putDouble(begun ? 0 : 1);
        Pose torso = robot.torso().toBodyAxes();
        put(state, torso.position());
        Rotation rotation = torso.rotation();
        state.putDouble(rotation.w())
                .putDouble(rotation.x())
                .putDouble(rotation.y())
                .putDouble(rotation.z());
        put(state, robot.torsoVelocity());
        put(state, SimSparkFrame.toBody(robot.gyroDegreesPerSecond()).times(PortableMath.toRadians(1)));
        put(state, ball.position());
        put(state, ball.velocity());
        put(state, ball.spin());
        put(state, robot.externalForce());
        put(state, robot.externalTorque());
        joints.forEach(joint -> state.putDouble(PortableMath.toRadians(robot.jointDegrees(joint.index()))));
        joints.forEach(joint -> state.putDouble(PortableMath.toRadians(robot.jointDegreesPerSecond(joint.index()))));
        for (double speed : radiansPerSecond) {
            state.putDouble(speed);
        }
        return state.array();
    }

    private static void put(ByteBuffer state, Vector3 vector) {
        state.putDouble(vector.x()).putDouble(vector.y()).putDouble(vector.z());
    }

    private static LinkMotion motion(ByteBuffer answer) {
        Vector3 position = vector(answer);
        Rotation rotation =
                new Rotation(answer.getDouble(), answer.getDouble(), answer.getDouble(), answer.getDouble());
        return new LinkMotion(BodyPose.ofBodyAxes(new Pose(position, rotation)), vector(answer), vector(answer));
    }

    private static Optional<FootForce> foot(ByteBuffer answer) {
        boolean touches = answer.getDouble() > 0;
        Vector3 point = SimSparkFrame.fromBody(vector(answer));
        Vector3 force = SimSparkFrame.fromBody(vector(answer));
        return touches ? Optional.of(new FootForce(point, force)) : Optional.empty();
    }

    private static Vector3 vector(ByteBuffer answer) {
        return new Vector3(answer.getDouble(), answer.getDouble(), answer.getDouble());
    }
}

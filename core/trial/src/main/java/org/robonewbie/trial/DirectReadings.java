package org.robonewbie.trial;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.jspecify.annotations.Nullable;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.FootForce;
import org.robonewbie.protocol.perceptor.FootForces;
import org.robonewbie.protocol.perceptor.GameState;
import org.robonewbie.protocol.perceptor.JointAngles;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PerceptorMessageWriter;
import org.robonewbie.protocol.perceptor.Vision;
import org.robonewbie.simulator.world.Robot;

/**
 * Readings taken directly from the world. Individual values are rounded as in messages; a complete message is encoded and
 * parsed only on demand.
 */
final class DirectReadings implements SensorReadings {

    private final JointAngles angles;
    private final Vector3 gyro;
    private final Vector3 acceleration;
    private final FootForces feet;
    private final GameState game;
    private final Optional<Vision> picture;
    private @Nullable TextReadings whole;

    DirectReadings(Robot robot, DirectWorld world, boolean seeing) {
        angles = JointAngles.measured(robot::jointDegrees, List.of());
        gyro = robot.gyroDegreesPerSecond();
        acceleration = robot.acceleration();
        feet = robot.footForces();
        OptionalInt none = OptionalInt.empty();
        game = new GameState(none, Optional.empty(), none, none, world.seconds(), world.playModeName());
        picture = seeing ? world.picture(robot) : Optional.empty();
    }

    @Override
    public double degrees(Joint joint) {
        return PerceptorMessageWriter.rounded(angles.degreesOr(joint, 0));
    }

    @Override
    public Vector3 gyro() {
        return rounded(gyro);
    }

    @Override
    public Vector3 acceleration() {
        return rounded(acceleration);
    }

    @Override
    public FootForces feet() {
        return new FootForces(
                rounded(feet.left()), rounded(feet.right()), rounded(feet.leftToe()), rounded(feet.rightToe()));
    }

    @Override
    public Optional<Vision> picture() {
        return picture;
    }

    @Override
    public PerceptorMessage message() {
        return whole().message();
    }

    @Override
    public MessageBuffer text() {
        return whole().text();
    }

    private TextReadings whole() {
        TextReadings written = whole == null ? new TextReadings(written()) : whole;
        whole = written;
        return written;
    }

    private MessageBuffer written() {
        MessageBuffer text = new MessageBuffer();
        new PerceptorMessageWriter(text)
                .write(new PerceptorMessage(
                        OptionalDouble.of(game.playSeconds()),
                        Optional.of(game),
                        List.of(),
                        Optional.of(gyro),
                        Optional.of(acceleration),
                        angles,
                        feet,
                        picture));
        return text;
    }

    private static Optional<FootForce> rounded(Optional<FootForce> foot) {
        return foot.map(measured -> new FootForce(rounded(measured.point()), rounded(measured.force())));
    }

    private static Vector3 rounded(Vector3 reading) {
        return new Vector3(
                PerceptorMessageWriter.rounded(reading.x()),
                PerceptorMessageWriter.rounded(reading.y()),
                PerceptorMessageWriter.rounded(reading.z()));
    }
}

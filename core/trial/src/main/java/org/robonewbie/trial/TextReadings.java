package org.robonewbie.trial;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.FootForces;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PerceptorMessageReader;
import org.robonewbie.protocol.perceptor.Vision;

/** Readings in wire format, parsed on demand. */
final class TextReadings implements SensorReadings {

    private final MessageBuffer text;
    private @Nullable PerceptorMessage message;

    TextReadings(MessageBuffer text) {
        this.text = text;
    }

    @Override
    public MessageBuffer text() {
        return text;
    }

    @Override
    public PerceptorMessage message() {
        PerceptorMessage parsed = message == null ? new PerceptorMessageReader().read(text) : message;
        message = parsed;
        return parsed;
    }

    @Override
    public double degrees(Joint joint) {
        return message().jointAngles().degreesOr(joint, Double.NaN);
    }

    @Override
    public Vector3 gyro() {
        return or(message().gyro());
    }

    @Override
    public Vector3 acceleration() {
        return or(message().accelerometer());
    }

    @Override
    public FootForces feet() {
        return message().footForces();
    }

    @Override
    public Optional<Vision> picture() {
        return message().vision();
    }

    private static Vector3 or(Optional<Vector3> reading) {
        return reading.orElse(Vector3.ZERO);
    }
}

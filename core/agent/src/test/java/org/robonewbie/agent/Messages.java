package org.robonewbie.agent;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.protocol.perceptor.FootForce;
import org.robonewbie.protocol.perceptor.FootForces;
import org.robonewbie.protocol.perceptor.GameState;
import org.robonewbie.protocol.perceptor.Heard;
import org.robonewbie.protocol.perceptor.JointAngles;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.Vision;

/** Builds perceptor messages for tests, those of a robot that stands still unless something else is said. */
final class Messages {

    private double seconds = 1;
    private PlayMode playMode = PlayMode.PLAY_ON;
    private OptionalInt number = OptionalInt.of(4);
    private TeamSide side = TeamSide.LEFT;
    private Vector3 gyro = Vector3.ZERO;
    private Vector3 accelerometer = new Vector3(0, 0, 9.81);
    private Posture posture = Posture.ZERO;
    private List<Heard> heard = List.of();
    private Optional<FootForce> leftFoot = Optional.empty();
    private Optional<Vision> vision = Optional.empty();

    static Messages standing() {
        return new Messages();
    }

    Messages at(double newSeconds) {
        seconds = newSeconds;
        return this;
    }

    Messages in(PlayMode newPlayMode) {
        playMode = newPlayMode;
        return this;
    }

    Messages on(TeamSide newSide) {
        side = newSide;
        return this;
    }

    Messages withoutNumber() {
        number = OptionalInt.empty();
        return this;
    }

    Messages gyro(double x, double y, double z) {
        gyro = new Vector3(x, y, z);
        return this;
    }

    Messages accelerometer(double x, double y, double z) {
        accelerometer = new Vector3(x, y, z);
        return this;
    }

    Messages posture(Posture newPosture) {
        posture = newPosture;
        return this;
    }

    Messages heard(Heard... texts) {
        heard = List.of(texts);
        return this;
    }

    Messages leftFoot(Vector3 point, Vector3 force) {
        leftFoot = Optional.of(new FootForce(point, force));
        return this;
    }

    Messages seeing(Vision newVision) {
        vision = Optional.of(newVision);
        return this;
    }

    PerceptorMessage build() {
        GameState state = new GameState(
                number,
                number.isPresent() ? Optional.of(side) : Optional.empty(),
                OptionalInt.of(2),
                OptionalInt.of(1),
                seconds,
                playMode.simSparkName());
        return new PerceptorMessage(
                OptionalDouble.of(seconds),
                Optional.of(state),
                heard,
                Optional.of(gyro),
                Optional.of(accelerometer),
                JointAngles.measured(posture::degrees, List.of()),
                FootForces.of(leftFoot, Optional.empty()),
                vision);
    }
}

package org.robonewbie.agent.league;

import java.util.Optional;
import java.util.OptionalDouble;
import org.robonewbie.agent.perception.Direction;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.protocol.perceptor.GameState;
import org.robonewbie.protocol.perceptor.JointAngles;
import org.robonewbie.protocol.perceptor.LeaguePerception;
import org.robonewbie.protocol.perceptor.Vision;

/**
 * True positions for camera pictures: the server sends the pose of the torso. It does not send the place of the ball, but what the camera
 * sees has no noise; a ball out of sight stays where it was seen last.
 */
final class LeagueTruth {

    private static final Vector3 FORWARD = new Vector3(1, 0, 0);

    private final LeagueCamera camera;
    private Vector3 ball = Vector3.ZERO;

    LeagueTruth(LeagueCamera camera) {
        this.camera = camera;
    }

    /** Returns a picture with true positions; the same picture if the message does not contain the pose of the torso. */
    Vision addTo(Vision seen, LeaguePerception perception, JointAngles angles) {
        Optional<TeamSide> side = perception.message().gameState().flatMap(GameState::side);
        if (side.isEmpty()
                || perception.position().isEmpty()
                || perception.orientation().isEmpty()) {
            return seen;
        }
        Pose torso =
                new Pose(perception.position().get(), perception.orientation().get());
        Pose eye = torso.times(camera.pose(angles.degreesOr(Joint.NECK_YAW, 0), angles.degreesOr(Joint.NECK_PITCH, 0)));
        seen.ball()
                .map(polar -> new Direction(polar.distanceMetres(), polar.horizontalDegrees(), polar.verticalDegrees()))
                .ifPresent(direction -> ball = eye.transform(direction.toPoint()));
        double heading = BodyState.headingDegrees(eye.rotation().apply(FORWARD));
        return new Vision(
                seen.landmarks(),
                seen.ball(),
                seen.players(),
                seen.lines(),
                side.map(own -> own.inOtherFrame(eye.position())),
                OptionalDouble.of(side.get() == TeamSide.LEFT ? heading : Angles.wrap(heading + 180)),
                side.map(own -> own.inOtherFrame(ball)),
                seen.markings());
    }
}

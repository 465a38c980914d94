package org.robonewbie.simulator.sensing;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.random.RandomGenerator;
import org.robonewbie.nao.BodyPart;
import org.robonewbie.nao.Landmark;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.protocol.perceptor.PolarPosition;
import org.robonewbie.protocol.perceptor.Vision;
import org.robonewbie.protocol.perceptor.Vision.SeenBodyPart;
import org.robonewbie.protocol.perceptor.Vision.SeenLandmark;
import org.robonewbie.protocol.perceptor.Vision.SeenLine;
import org.robonewbie.protocol.perceptor.Vision.SeenPlayer;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.physics.RotationMatrix;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.simulator.world.SoccerWorld;

/**
 * Camera in the centre of a robot's head (SimSpark: {@code restrictedvisionperceptor.cpp}).
 *
 * <p>It detects the centres of all objects within its view cone, including the robot's own arms, without range limit or
 * occlusion. The server takes an image every third cycle.
 *
 * <pre>{@code
 * Camera camera = new Camera(world.field(), CameraSettings.STANDARD, random);
 * Vision vision = camera.look(robot, world, players, Optional.of(TeamSide.LEFT));
 * }</pre>
 */
public final class Camera implements Restorable {

    private static final List<BodyPart> PARTS = List.of(BodyPart.values());
    private static final List<Landmark> LANDMARKS = List.of(Landmark.values());

    /** Additive identity that preserves even -0. */
    private static final Vector3 NO_DISPLACEMENT = new Vector3(-0.0, -0.0, -0.0);

    private final List<Vector3> landmarks;
    private final CameraSettings settings;
    private final ViewCone cone;
    private final List<Segment> lines;
    private final Optional<VisionNoise> noise;
    private final List<SeenLandmark> seenLandmarks = new ArrayList<>();
    private final List<SeenPlayer> seenPlayers = new ArrayList<>();
    private final List<SeenLine> seenLines = new ArrayList<>();
    private final List<SeenBodyPart> parts = new ArrayList<>();
    private final double[] local = new double[3];
    private final double[] ends = new double[6];

    /**
     * Creates a camera and draws its constant calibration error.
     *
     * @param field the pitch with its landmarks and lines
     * @param settings view cone, noise, and which optional values are reported
     * @param random source of all noise; unused without noise
     */
    public Camera(SoccerField field, CameraSettings settings, RandomGenerator random) {
        this.landmarks = LANDMARKS.stream().map(field::position).toList();
        this.settings = settings;
        this.cone = new ViewCone(settings.horizontalConeDegrees(), settings.verticalConeDegrees());
        this.lines = settings.lines() ? FieldLines.of(field) : List.of();
        this.noise = settings.noise() ? Optional.of(new VisionNoise(random)) : Optional.empty();
    }

    /**
     * Takes an image.
     *
     * @param observer the robot whose head contains the camera
     * @param world the world with the ball
     * @param players all robots that belong to a team, in a fixed order, including the observer
     * @param side the side of the observer's team, which determines the frame of the true positions; empty if it has no
     *     team
     * @return the detected objects; values are not rounded
     */
    public Vision look(Robot observer, SoccerWorld world, List<VisiblePlayer> players, Optional<TeamSide> side) {
        BodyPose head = observer.linkPose(observer.nao().linkIndex(BodyPart.HEAD.simSparkName()));
        Vector3 ball = world.ball().position();
        return new Vision(
                landmarks(head),
                sees(head, ball) ? Optional.of(measure()) : Optional.empty(),
                players(head, players),
                lines(head),
                settings.ownPosition() ? Optional.of(inTeamView(head.position(), side)) : Optional.empty(),
                settings.ownOrientation() ? OptionalDouble.of(azimuth(head, side)) : OptionalDouble.empty(),
                settings.ballPosition() ? Optional.of(inTeamView(ball, side)) : Optional.empty());
    }

    private List<SeenLandmark> landmarks(BodyPose head) {
        seenLandmarks.clear();
        for (int i = 0; i < landmarks.size(); i++) {
            if (sees(head, landmarks.get(i))) {
                seenLandmarks.add(new SeenLandmark(LANDMARKS.get(i), measure()));
            }
        }
        return seenLandmarks;
    }

    private List<SeenPlayer> players(BodyPose head, List<VisiblePlayer> players) {
        seenPlayers.clear();
        for (int i = 0; i < players.size(); i++) {
            VisiblePlayer player = players.get(i);
            measureParts(head, player);
            if (!parts.isEmpty()) {
                seenPlayers.add(new SeenPlayer(player.team(), player.number(), parts, Optional.empty()));
            }
        }
        return seenPlayers;
    }

    private void measureParts(BodyPose head, VisiblePlayer player) {
        parts.clear();
        for (int i = 0; i < PARTS.size(); i++) {
            if (sees(head, player.parts().get(i))) {
                parts.add(new SeenBodyPart(PARTS.get(i), measure()));
            }
        }
    }

    private List<SeenLine> lines(BodyPose head) {
        seenLines.clear();
        for (int i = 0; i < lines.size(); i++) {
            if (isVisible(head, lines.get(i))) {
                PolarPosition start = measure(ends[0], ends[1], ends[2]);
                seenLines.add(new SeenLine(start, measure(ends[3], ends[4], ends[5])));
            }
        }
        return seenLines;
    }

    /** Returns whether part of a line is visible, and stores the ends of that part in {@link #ends}. */
    private boolean isVisible(BodyPose head, Segment line) {
        locate(head, line.start());
        System.arraycopy(local, 0, ends, 0, 3);
        locate(head, line.end());
        System.arraycopy(local, 0, ends, 3, 3);
        return (ends[1] > 0 || ends[4] > 0) && cone.clip(ends);
    }

    /**
     * Returns whether a point is visible, and stores its position in {@link #local}. Does not allocate memory, because
     * most points are not visible.
     */
    private boolean sees(BodyPose head, Vector3 point) {
        locate(head, point);
        return cone.contains(local[0], local[1], local[2]);
    }

    /** Transforms a point to the head frame. Adds the calibration error, which therefore affects visibility. */
    private void locate(BodyPose head, Vector3 point) {
        RotationMatrix rotation = head.rotation();
        double x = point.x() - head.position().x();
        double y = point.y() - head.position().y();
        double z = point.z() - head.position().z();
        Vector3 displacement = noise.isPresent() ? noise.get().displacement() : NO_DISPLACEMENT;
        local[0] = rotation.xx() * x + rotation.yx() * y + rotation.zx() * z + displacement.x();
        local[1] = rotation.xy() * x + rotation.yy() * y + rotation.zy() * z + displacement.y();
        local[2] = rotation.xz() * x + rotation.yz() * y + rotation.zz() * z + displacement.z();
    }

    private PolarPosition measure() {
        return measure(local[0], local[1], local[2]);
    }

    private PolarPosition measure(double x, double y, double z) {
        double metres = Math.sqrt(x * x + y * y + z * z);
        double left = Angles.atan2(-x, y);
        double up = Angles.atan2(z, PortableMath.hypot(x, y));
        return noise.isPresent() ? noise.get().disturb(metres, left, up) : new PolarPosition(metres, left, up);
    }

    private static Vector3 inTeamView(Vector3 world, Optional<TeamSide> side) {
        boolean right = side.isPresent() && side.get() == TeamSide.RIGHT;
        return right ? new Vector3(-world.x(), -world.y(), world.z()) : world;
    }

    private static double azimuth(BodyPose head, Optional<TeamSide> side) {
        return BodyState.headingDegrees(inTeamView(head.rotation().axisY(), side));
    }

    /** Saves the state of the noise, the only mutable state. */
    @Override
    public void save(StateWriter out) {
        noise.ifPresent(errors -> errors.save(out));
    }

    @Override
    public void restore(StateReader in) {
        noise.ifPresent(errors -> errors.restore(in));
    }
}

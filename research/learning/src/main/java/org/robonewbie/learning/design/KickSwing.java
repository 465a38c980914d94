package org.robonewbie.learning.design;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robonewbie.learning.rehearsal.Rehearsal;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.model.Link;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.BallPlace;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.trial.Measure;
import org.robonewbie.trial.WorldState;

/**
 * A kick with the right foot into the air: the way of the foot, from which follows what it would do to a ball in any place. The ball is light;
 * it changes the foot's way little. So one trial tells at once where the ball should lie.
 *
 * @param start where the robot stood
 * @param boxes half the sizes of the links that may meet the ball, in metres: foot and, if there is one, toe
 * @param limbs where the links really were after each cycle
 * @param overlap how much limbs were within each other, metres times cycles
 * @param standing whether the robot ended in the stance
 * @param fallCost 0 if it stands, up to 1 the earlier it falls
 */
record KickSwing(
        Pose2d start,
        Map<String, Vector3> boxes,
        List<Map<String, Pose>> limbs,
        double overlap,
        boolean standing,
        double fallCost) {

    private static final double RADIUS = 0.042;
    private static final double REACH = 0.15;
    private static final double PUSH_NEWTONS = 2;
    private static final int CYCLES_OF_SHIFT = 20;

    /** A ball leaves the foot with 0.8 of the speed with which they met; the soft contact eats 3 %. */
    private static final double BOUNCE = 0.8;

    private static final double SOFTNESS = 1.033;

    /** Metres that a ball comes for each metre per second: it begins with spin, because it touches the ground when it is hit. */
    private static final double ROLLING_SECONDS = 0.93;

    /** How much farther it comes for each metre per second upwards, since a ball in the air does not roll. */
    private static final double FLIGHT_SECONDS = 0.1;

    private static final double MOST_UPWARDS = 5;
    private static final double INSIDE = 0.004;

    /** What becomes of a ball: how far it gets ahead and to the left, in metres. */
    record Shot(double ahead, double left) {

        static final Shot NONE = new Shot(0, 0);
    }

    /** Plays a kick without a ball. */
    static KickSwing of(RobotType type, Motion kick, long seed) {
        try (Rehearsal robot = Rehearsal.inStance(type, seed, PUSH_NEWTONS)) {
            NaoModel model = NaoModel.of(type);
            Watch watch = new Watch(robot, model);
            robot.watch(watch);
            robot.play(kick);
            double seconds = robot.seconds();
            boolean standing = robot.endsInStance();
            double planned = kick.durationMillis() / 1000.0;
            return new KickSwing(
                    robot.start(),
                    boxes(model),
                    watch.poses,
                    watch.overlap,
                    standing,
                    standing ? 0 : 1 - Math.min(1, seconds / planned));
        }
    }

    private static Map<String, Vector3> boxes(NaoModel model) {
        return model.links().stream()
                .filter(link -> link.name().equals("rfoot") || link.name().equals("rtoe"))
                .collect(Collectors.toMap(Link::name, LimbOverlap::half, (one, other) -> one, TreeMap::new));
    }

    private static final class Watch implements Measure {

        private final Rehearsal robot;
        private final LimbOverlap limbs;
        private final List<String> links;
        private final List<Map<String, Pose>> poses = new ArrayList<>();
        private double overlap;

        Watch(Rehearsal robot, NaoModel model) {
            this.robot = robot;
            this.limbs = new LimbOverlap(model);
            this.links = Stream.concat(LimbOverlap.links().stream(), boxes(model).keySet().stream())
                    .distinct()
                    .toList();
        }

        @Override
        public void see(WorldState state) {
            Map<String, Pose> now = links.stream().collect(Collectors.toMap(link -> link, robot::link));
            poses.add(now);
            overlap += limbs.metres(robot::link);
        }

        @Override
        public double value() {
            return overlap;
        }
    }

    /** Predicts what a ball does that lies at a place before the robot. */
    Shot shot(BallPlace place) {
        Vector3 ground = start.pointAt(place.ahead(), place.left());
        Vector3 ball = new Vector3(ground.x(), ground.y(), RADIUS);
        for (int i = CYCLES_OF_SHIFT; i < limbs.size() - 1; i++) {
            for (Map.Entry<String, Vector3> box : boxes.entrySet()) {
                Pose pose = pose(i, box.getKey());
                if (pose.position().distanceTo(ball) < REACH) {
                    Vector3 touch = nearest(pose.inverse().transform(ball), box.getValue());
                    double distance = pose.transform(touch).distanceTo(ball);
                    if (distance < RADIUS) {
                        return distance < INSIDE ? Shot.NONE : hit(i, box.getKey(), touch, ball);
                    }
                }
            }
        }
        return Shot.NONE;
    }

    private Pose pose(int cycle, String link) {
        return Optional.ofNullable(limbs.get(cycle).get(link)).orElseThrow();
    }

    private static Vector3 nearest(Vector3 point, Vector3 half) {
        return new Vector3(clamp(point.x(), half.x()), clamp(point.y(), half.y()), clamp(point.z(), half.z()));
    }

    private static double clamp(double value, double most) {
        return Math.max(-most, Math.min(most, value));
    }

    /** What a link does to a ball that it touches in a cycle with a point of its box. */
    private Shot hit(int cycle, String link, Vector3 touch, Vector3 ball) {
        Vector3 point = pose(cycle, link).transform(touch);
        Vector3 outwards = ball.minus(point);
        Vector3 normal = outwards.times(1 / outwards.length());
        Vector3 earlier = pose(cycle - 1, link).transform(touch);
        Vector3 later = pose(cycle + 1, link).transform(touch);
        double before = point.minus(earlier).dot(normal) / Cycle.SECONDS;
        double after = later.minus(point).dot(normal) / Cycle.SECONDS;
        double speed = Math.max(0, (BOUNCE * before + after) / SOFTNESS);
        double upwards = Math.max(0, Math.min(MOST_UPWARDS, speed * normal.z()));
        double metres = speed * ROLLING_SECONDS * (1 + FLIGHT_SECONDS * upwards);
        Vector3 way = start.pointAt(1, 0).minus(start.pointAt(0, 0));
        Vector3 aside = start.pointAt(0, 1).minus(start.pointAt(0, 0));
        return new Shot(metres * normal.dot(way), metres * normal.dot(aside));
    }
}

package org.robonewbie.workshop.motion;

import java.util.Arrays;
import java.util.Random;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.localisation.SelfLocalisation;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.kinematics.ForwardKinematics;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;

/**
 * Errors of self-localisation while a robot walks on the league pitch for a minute, with noise, and is pushed over twice. Falls and get-ups
 * are included; the first three seconds, in which the robot looks around, are not. All errors are sorted in ascending order, one per cycle.
 *
 * @param metres position errors in metres
 * @param degrees heading errors in degrees
 * @param cameraMetres errors of the camera height in metres
 * @param tiltDegrees errors of the vertical direction in degrees
 */
@SuppressWarnings("ArrayRecordComponent")
public record LocalisationTrial(double[] metres, double[] degrees, double[] cameraMetres, double[] tiltDegrees) {

    private static final double SECONDS = 60;
    private static final double BEGIN = 3;
    private static final double[] FALLS = {20, 40};
    private static final double PUSH_SECONDS = 0.3;
    private static final double PUSH_NEWTONS = 60;
    private static final Vector3 UP = new Vector3(0, 0, 1);

    /**
     * Runs a trial.
     *
     * @param seed seed of the start pose, the walks, the falls and the noise
     * @param type the robot type
     * @param style the walk style
     * @return the errors
     */
    public static LocalisationTrial run(long seed, RobotType type, WalkStyle style) {
        Random random = new Random(29 * seed + 5);
        random.nextLong();
        Pose2d place =
                new Pose2d(-10 + 8 * random.nextDouble(), -6 + 12 * random.nextDouble(), 360 * random.nextDouble());
        Vector3[] pushes = {push(random), push(random)};
        Scene scene = Scene.of(RobotStart.at(place).withType(type).after("stand"))
                .withParameters(SoccerParameters.league())
                .withBall(new Vector3(0, -9, 0));
        Wanderer wanderer = new Wanderer(random, style);
        try (Trial trial = Trial.served(scene, seed, Controller.ofAgent(wanderer))) {
            trial.with(during -> throwOver(during, pushes));
            return watched(trial, wanderer.self);
        }
    }

    private static Vector3 push(Random random) {
        double direction = 2 * Math.PI * random.nextDouble();
        return new Vector3(Math.cos(direction), Math.sin(direction), 0).times(PUSH_NEWTONS);
    }

    /** Pushes the robot over twice per trial. */
    private static void throwOver(Trial trial, Vector3[] pushes) {
        for (int i = 0; i < FALLS.length; i++) {
            double since = trial.seconds() - FALLS[i];
            if (since >= 0 && since < PUSH_SECONDS) {
                trial.robot(0).push(pushes[i]);
            }
        }
    }

    /**
     * Returns the median.
     *
     * @param sorted errors in ascending order
     * @return the median
     */
    public static double median(double[] sorted) {
        return sorted[sorted.length / 2];
    }

    /**
     * Returns the 95th percentile.
     *
     * @param sorted errors in ascending order
     * @return the 95th percentile
     */
    public static double most(double[] sorted) {
        return sorted[sorted.length * 95 / 100];
    }

    private static LocalisationTrial watched(Trial trial, SelfLocalisation self) {
        int cycles = (int) Math.round((SECONDS - BEGIN) * 50);
        double[][] errors = new double[4][cycles];
        while (trial.seconds() < BEGIN) {
            trial.step();
        }
        for (int i = 0; i < cycles; i++) {
            BodyState truth = trial.now().robot();
            trial.step();
            Pose2d belief = self.pose();
            Pose torso = believed(self);
            errors[0][i] = Math.hypot(
                    truth.position().x() - belief.x(), truth.position().y() - belief.y());
            errors[1][i] = Math.abs(Angles.wrap(belief.degrees() - truth.headingDegrees()));
            errors[2][i] = Math.abs(
                    camera(torso, truth).z() - camera(truth.torso(), truth).z());
            errors[3][i] = angle(up(torso), up(truth.torso()));
        }
        for (double[] row : errors) {
            Arrays.sort(row);
        }
        return new LocalisationTrial(errors[0], errors[1], errors[2], errors[3]);
    }

    private static Pose believed(SelfLocalisation self) {
        Pose2d place = self.pose();
        return new Pose(
                new Vector3(place.x(), place.y(), self.heightMetres()),
                Rotation.ofYawPitchRoll(place.degrees(), self.leanDegrees(), self.rollDegrees()));
    }

    private static Vector3 camera(Pose torso, BodyState robot) {
        ForwardKinematics kinematics = ForwardKinematics.of(robot.type());
        return torso.transform(kinematics
                .camera(robot.degrees(Joint.NECK_YAW), robot.degrees(Joint.NECK_PITCH))
                .position());
    }

    /** Returns the vertical direction in the frame of a torso. */
    private static Vector3 up(Pose torso) {
        return torso.rotation().inverse().apply(UP);
    }

    private static double angle(Vector3 one, Vector3 other) {
        return Math.toDegrees(Math.atan2(one.cross(other).length(), one.dot(other)));
    }

    /** Walks in random directions, turns inwards near the border, and gets up after a fall. */
    private static final class Wanderer extends Agent {

        private static final double BORDER = 3;

        private final SelfLocalisation self = new SelfLocalisation();
        private final Random random;
        private final WalkStyle style;
        private double until;
        private double forward;
        private double turn;

        Wanderer(Random random, WalkStyle style) {
            this.random = random;
            this.style = style;
            walk.setStyle(style);
        }

        @Override
        protected void think() {
            self.update(nao, fieldView);
            lookAround.look();
            if (nao.isFallen() && motions.isFinished()) {
                motions.startGetUp();
            } else if (motions.isFinished() && nao.getTime() > 1) {
                stroll();
            }
        }

        private void stroll() {
            if (nao.getTime() > until) {
                until = nao.getTime() + 1 + 3 * random.nextDouble();
                forward = (0.3 + 0.7 * random.nextDouble()) * style.most().forward();
                turn = style.most().turn() * random.nextGaussian() / 3;
            }
            walk.towards(forward, 0, isNearBorder() ? turnInwards() : turn);
        }

        private boolean isNearBorder() {
            Pose2d pose = self.pose();
            return Math.abs(pose.x()) > self.field().length() / 2 - BORDER
                    || Math.abs(pose.y()) > self.field().width() / 2 - BORDER;
        }

        private double turnInwards() {
            Vector3 centre = self.pose().fromFrame(Vector3.ZERO);
            return Math.toDegrees(Math.atan2(centre.y(), centre.x()));
        }
    }
}

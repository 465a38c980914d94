package org.robonewbie.learning.rehearsal;

import java.util.Arrays;
import java.util.Random;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.localisation.GroundPose;
import org.robonewbie.agent.localisation.SelfLocalisation;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.trial.Performer;
import org.robonewbie.trial.Place;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;

/**
 * A robot that walks about on the league's pitch for a minute, with noise, and falls once; how far its belief is from the truth.
 * The first three seconds, in which it looks around, do not count.
 *
 * @param metres distance between believed and true place in each cycle, in ascending order
 * @param degrees difference between believed and true heading in each cycle, in ascending order
 */
@SuppressWarnings("ArrayRecordComponent")
public record LocalisationTrial(double[] metres, double[] degrees) {

    private static final double SECONDS = 60;
    private static final double BEGIN = 3;
    private static final double FALL = 30;
    private static final double PUSH_SECONDS = 0.3;
    private static final double PUSH_NEWTONS = 60;

    /**
     * Carries out a trial.
     *
     * @param seed chooses the place, the ways and the noise
     * @param type how the robot is built
     * @param style how it walks
     * @return what it believed
     */
    public static LocalisationTrial run(long seed, RobotType type, WalkStyle style) {
        Random random = new Random(29 * seed + 5);
        random.nextLong();
        Place place =
                new Place(-10 + 8 * random.nextDouble(), -6 + 12 * random.nextDouble(), 360 * random.nextDouble());
        Scene scene = Scene.of(RobotStart.at(place).withType(type).after("stand"))
                .withParameters(SoccerParameters.league())
                .withBall(new Vector3(0, -9, 0));
        Wanderer wanderer = new Wanderer(random, style);
        try (Trial trial = Trial.served(scene, seed, Performer.ofAgent(wanderer))) {
            trial.with(LocalisationTrial::push);
            return watched(trial, wanderer.self);
        }
    }

    /** {@return the median of the distances, metres} */
    public double medianMetres() {
        return metres[metres.length / 2];
    }

    /** {@return the distance that 95 % of all do not exceed, metres} */
    public double mostMetres() {
        return metres[metres.length * 95 / 100];
    }

    /** {@return the median of the differences in heading, degrees} */
    public double medianDegrees() {
        return degrees[degrees.length / 2];
    }

    private static LocalisationTrial watched(Trial trial, SelfLocalisation self) {
        int cycles = (int) Math.round((SECONDS - BEGIN) * 50);
        double[] metres = new double[cycles];
        double[] degrees = new double[cycles];
        while (trial.seconds() < BEGIN) {
            trial.step();
        }
        for (int i = 0; i < cycles; i++) {
            Place truth = trial.now().place();
            trial.step();
            GroundPose belief = self.pose();
            metres[i] = truth.distance(new Vector3(belief.x(), belief.y(), 0));
            degrees[i] = Math.abs(Math.IEEEremainder(belief.headingDegrees() - truth.degrees(), 360));
        }
        Arrays.sort(metres);
        Arrays.sort(degrees);
        return new LocalisationTrial(metres, degrees);
    }

    /** Throws the robot over once. */
    private static void push(Trial trial) {
        double since = trial.seconds() - FALL;
        if (since >= 0 && since < PUSH_SECONDS) {
            trial.robot(0).push(new Vector3(PUSH_NEWTONS, 0, 0));
        }
    }

    /** Walks somewhere else every few seconds, inwards near the border, and gets up when it has fallen. */
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
            GroundPose pose = self.pose();
            return Math.abs(pose.x()) > self.field().length() / 2 - BORDER
                    || Math.abs(pose.y()) > self.field().width() / 2 - BORDER;
        }

        private double turnInwards() {
            Vector3 centre = self.pose().fromFrame(Vector3.ZERO);
            return Math.toDegrees(Math.atan2(centre.y(), centre.x()));
        }
    }
}

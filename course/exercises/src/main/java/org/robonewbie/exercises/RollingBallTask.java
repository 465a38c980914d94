package org.robonewbie.exercises;

import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;

/** Task: report the position of a ball that rolls past the robot and out of view, once on each side. */
final class RollingBallTask implements Task {

    private static final Pose2d STUDENT = new Pose2d(-1, 0, 0);
    private static final Pattern WORDS = Pattern.compile("ball:(-?\\d{1,2}(?:\\.\\d+)?):(-?\\d{1,2}(?:\\.\\d+)?)");
    private static final double[] SHOT_SECONDS = {3, 10};
    private static final double UNSEEN_DEGREES = 65;
    private static final double JUDGED_FROM_SECONDS = 0.5;
    private static final double JUDGED_UNTIL_SECONDS = 2.5;
    private static final double STRAIGHT_DEGREES = 15;
    private static final double GOOD_METRES = 0.35;
    private static final int MIN_WORDS = 50;

    private final Vector3[] starts = new Vector3[SHOT_SECONDS.length];
    private final Vector3[] velocities = new Vector3[SHOT_SECONDS.length];
    private final double[] sumsOfErrors = new double[SHOT_SECONDS.length];
    private final int[] words = new int[SHOT_SECONDS.length];
    private Optional<String> said = Optional.empty();
    private int shots;
    private double lostSeconds = Double.POSITIVE_INFINITY;
    private double headTurned;

    @Override
    public Scene scene(RandomSource random) {
        double side = random.side();
        for (int i = 0; i < SHOT_SECONDS.length; i++) {
            double aside = side * (i == 0 ? 1 : -1);
            starts[i] = STUDENT.pointAt(random.between(2, 2.4), aside * random.between(0.5, 0.7));
            velocities[i] = new Vector3(-random.between(3.3, 4), aside * random.between(0, 0.4), 0);
        }
        return Scene.of(RobotStart.at(STUDENT).after("stand")).withBall(starts[0]);
    }

    @Override
    public void act(Trial trial) {
        said = trial.said(0);
        if (shots > 0 && shots < SHOT_SECONDS.length && trial.seconds() >= SHOT_SECONDS[shots] - 2 && isLost()) {
            lostSeconds = Double.POSITIVE_INFINITY;
            trial.placeBall(starts[shots]);
        }
        if (shots < SHOT_SECONDS.length && trial.seconds() >= SHOT_SECONDS[shots]) {
            trial.ball().setVelocity(velocities[shots]);
            shots++;
        }
    }

    private boolean isLost() {
        return Double.isFinite(lostSeconds);
    }

    @Override
    public void see(WorldState state) {
        headTurned = Math.max(headTurned, Math.abs(state.robot().degrees(Joint.NECK_YAW)));
        boolean rolling = shots > 0 && state.ballVelocity().length() > 0.01;
        if (rolling && !isLost() && Math.abs(state.place().bearing(state.ball())) > UNSEEN_DEGREES) {
            lostSeconds = state.seconds();
        }
        double unseen = state.seconds() - lostSeconds;
        if (unseen >= JUDGED_FROM_SECONDS && unseen <= JUDGED_UNTIL_SECONDS) {
            said.map(WORDS::matcher).filter(Matcher::matches).ifPresent(match -> {
                double ahead = state.place().ahead(state.ball()) - Double.parseDouble(match.group(1));
                double left = state.place().left(state.ball()) - Double.parseDouble(match.group(2));
                sumsOfErrors[shots - 1] += PortableMath.hypot(ahead, left);
                words[shots - 1]++;
            });
        }
    }

    @Override
    public Score score() {
        String finding = "first ball " + describe(0) + ", second ball " + describe(1);
        if (headTurned > STRAIGHT_DEGREES) {
            return Score.failed(
                    1,
                    finding,
                    "The head must look straight ahead (NECK_YAW within 15°), so that the ball goes out"
                            + " of sight.");
        }
        if (Math.min(words[0], words[1]) < MIN_WORDS) {
            return Score.failed(
                    0,
                    finding,
                    "In every cycle, say how far ahead and how far to the left the ball is, even when it is out of"
                            + " sight, for example with nao.say(\"ball:-0.85:0.40\").");
        }
        double worst = Math.max(error(0), error(1));
        return worst <= GOOD_METRES
                ? Score.passed(finding)
                : Score.failed(
                        4 - 2 * worst,
                        finding,
                        "Two positions and the time between them give the velocity. It decreases while the ball"
                                + " rolls: by what fraction per second? Discard the velocity when the ball is at rest"
                                + " again.");
    }

    private double error(int shot) {
        return sumsOfErrors[shot] / Math.max(1, words[shot]);
    }

    private String describe(int shot) {
        return words[shot] < MIN_WORDS ? "not said" : String.format(Locale.ROOT, "%.2f m off", error(shot));
    }
}

package org.robonewbie.workshop.team;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.LongFunction;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.team.skill.CloseDribbleNumbers;
import org.robonewbie.team.skill.KickKind;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;
import org.robonewbie.workshop.motion.MotionCheck;
import org.robonewbie.workshop.motion.Outcome;

/** Checks how a player of the example team dribbles, and how it kicks while walking, on the league pitch. */
public final class PlayerChecks {

    private static final Pose2d START = new Pose2d(-8, 0, 0);
    private static final double BALL_AHEAD = 1.5;
    private static final double ASIDE_METRES = 0.1;
    private static final double MAX_SECONDS = 30;
    private static final double NEAR_METRES = 0.3;
    private static final double KICKED_METRES_PER_SECOND = 1;
    private static final double ROLLING_SECONDS = 4;
    private static final double KICK_METRES = 3;
    private static final double FAR_METRES = 8;
    private static final double KICK_SECONDS = 2;
    private static final double KICK_DEGREES = 5;

    private final RobotType type;

    private PlayerChecks(RobotType type) {
        this.type = type;
    }

    /** Result of a kick. */
    private record Kicked(double metres, double seconds, double degrees) {

        static final Kicked NONE = new Kicked(0, Double.POSITIVE_INFINITY, 180);
    }

    /**
     * Returns the checks of one robot type.
     *
     * @param type the robot type
     * @return the checks in the order of the table
     */
    public static List<MotionCheck> all(RobotType type) {
        return new PlayerChecks(type).all();
    }

    private List<MotionCheck> all() {
        return Stream.of(
                        dribbles(),
                        kicks("kick", KickKind.QUICK, KICK_METRES),
                        kicks("far kick", KickKind.FAR, FAR_METRES))
                .flatMap(List::stream)
                .toList();
    }

    private List<MotionCheck> dribbles() {
        return List.of(
                dribble(
                        "dribble 5 m",
                        "the ball advances 5 m within 10 s",
                        "s",
                        DribbleTrial::seconds,
                        DribbleTrial::isInTime),
                dribble(
                        "dribble 5 m, close",
                        "the ball advances 5 m within 10 s and is never more than 0.5 m away",
                        "m, the farthest",
                        DribbleTrial::farthest,
                        DribbleTrial::isClose));
    }

    private List<MotionCheck> kicks(String name, KickKind kind, double metres) {
        return List.of(
                kick(
                        name + " out of the walk",
                        kind,
                        String.format(Locale.ROOT, "the ball rolls at least %.0f m", metres),
                        "m",
                        Kicked::metres,
                        kicked -> kicked.metres >= metres),
                kick(
                        name + " out of the walk, soon",
                        kind,
                        String.format(
                                Locale.ROOT,
                                "the ball rolls at least %.0f m and is faster than 1 m/s within 2 s after the robot came within 0.3 m",
                                metres),
                        "s",
                        Kicked::seconds,
                        kicked -> kicked.metres >= metres && kicked.seconds <= KICK_SECONDS),
                kick(
                        name + " out of the walk, straight",
                        kind,
                        String.format(
                                Locale.ROOT,
                                "the ball rolls at least %.0f m, within 5° of the intended direction",
                                metres),
                        "degrees to either side",
                        Kicked::degrees,
                        kicked -> kicked.metres >= metres && kicked.degrees <= KICK_DEGREES));
    }

    private MotionCheck dribble(
            String name,
            String rule,
            String unit,
            ToDoubleFunction<DribbleTrial> value,
            Predicate<DribbleTrial> success) {
        return check(
                name,
                DribbleTrial.BALL_AHEAD,
                rule,
                unit,
                value,
                success,
                seed -> DribbleTrial.served(type, CloseDribbleNumbers.FOUND, seed));
    }

    private MotionCheck kick(
            String name,
            KickKind kind,
            String rule,
            String unit,
            ToDoubleFunction<Kicked> value,
            Predicate<Kicked> success) {
        return check(name, BALL_AHEAD, rule, unit, value, success, seed -> {
            try (Trial trial = trial(seed, new BallPlayer(kind))) {
                return kick(trial);
            }
        });
    }

    private <T> MotionCheck check(
            String name,
            double ballAhead,
            String rule,
            String unit,
            ToDoubleFunction<T> value,
            Predicate<T> success,
            LongFunction<T> act) {
        return new MotionCheck(
                name + (type == RobotType.TYPE_0 ? "" : ", type " + type.ordinal()),
                "a player of the example team on its own simulator with noise and the league's pitch, in the stance, ball "
                        + ballAhead + " m ahead and up to 10 cm to the side",
                rule,
                unit,
                seed -> {
                    T done = act.apply(seed);
                    return new Outcome(success.test(done), value.applyAsDouble(done));
                });
    }

    private Trial trial(long seed, BallPlayer player) {
        return Trial.served(scene(type, BALL_AHEAD, seed), seed, Controller.ofAgent(player));
    }

    /**
     * Returns a scene on the league pitch with a robot in its standing posture and the ball ahead of it, offset
     * sideways by an amount that depends on the seed.
     */
    static Scene scene(RobotType type, double ballAhead, long seed) {
        double aside = ASIDE_METRES * Math.sin((double) seed);
        return Scene.of(RobotStart.at(START).withType(type).after("stand"))
                .withParameters(SoccerParameters.league())
                .withBall(START.pointAt(ballAhead, aside));
    }

    private Kicked kick(Trial trial) {
        Vector3 begin = trial.now().ball();
        Optional<Double> near = Optional.empty();
        while (trial.seconds() < MAX_SECONDS) {
            WorldState now = trial.step();
            if (near.isEmpty() && now.place().distance(now.ball()) < NEAR_METRES) {
                near = Optional.of(now.seconds());
            }
            if (near.isPresent() && now.ballVelocity().length() > KICKED_METRES_PER_SECOND) {
                trial.run(now.seconds() + ROLLING_SECONDS);
                Vector3 way = trial.now().ball().minus(begin);
                double degrees = Math.abs(Math.toDegrees(Math.atan2(way.y(), way.x())));
                return new Kicked(Math.hypot(way.x(), way.y()), now.seconds() - near.get(), degrees);
            }
        }
        return Kicked.NONE;
    }
}

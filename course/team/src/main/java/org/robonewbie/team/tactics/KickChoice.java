package org.robonewbie.team.tactics;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.team.skill.Footwork;
import org.robonewbie.team.skill.Kick;
import org.robonewbie.team.skill.KickKind;
import org.robonewbie.team.talk.TeamRole;
import org.robonewbie.team.world.Mate;
import org.robonewbie.team.world.Situation;
import org.robonewbie.team.world.WorldModel;

/**
 * Chooses what to do with the ball: the option with the highest expected gain per second.
 *
 * <p>Each option moves the ball to a position, takes some time, and succeeds with some probability. {@link #value} is the value
 * of a ball position: 1 in the opponents' goal, −1 in the team's own goal. The gain is the expected value afterwards, weighted
 * by the probability that each team then has the ball, minus the current value.
 */
public final class KickChoice {

    private static final double STEP_DEGREES = 15;
    private static final double DRIBBLE_METRES = 2;
    private static final double TAP_IN_METRES = 2.5;
    private static final double DRIBBLE_SPEED = 0.45;
    private static final double RUN_SPEED = 0.75;
    private static final double OPPONENT_SPEED = 0.65;
    private static final double DISTURBED = 0.3;
    private static final double ALONE_METRES = 4;
    private static final double SHARE_OF_RUN = 0.33;
    private static final double LOSS = 0.1;
    private static final double LOSS_SECONDS = 3;
    private static final double SET_PLAY_LOSS = 0.4;
    private static final double KICK_OFF_METRES = 1.5;
    private static final double VALUE_METRES = 8;
    private static final double STOPS = 0.9;
    private static final double STOPS_HIGH = 0.2;
    private static final double LANE_METRES = 0.3;
    private static final double LANE_SLOPE = 0.1;
    private static final double SHOT_DEVIATION_DEGREES = 6;
    private static final double PASS_SHARE = 3.5 / KickKind.QUICK.metres();
    private static final double LOYALTY = 0.6;
    private static final double SAME_DEGREES = 20;

    private final WorldModel world;
    private final boolean mayDribble;
    private final boolean mayScore;
    private final Plan before;
    private final List<Option> options;

    /**
     * Evaluates all options.
     *
     * @param world the world model
     * @param mayDribble whether the player may touch the ball more than once
     * @param mayScore whether a goal would count
     * @param before the current plan, which is preferred because changing it takes time
     */
    public KickChoice(WorldModel world, boolean mayDribble, boolean mayScore, Plan before) {
        this.world = world;
        this.mayDribble = mayDribble;
        this.mayScore = mayScore;
        this.before = before;
        this.options = all();
    }

    /**
     * An option for playing the ball.
     *
     * @param plan the plan that the player would follow
     * @param gain expected gain per second
     */
    public record Option(Plan plan, double gain) {}

    /** {@return the best option} */
    public Plan best() {
        return options.stream()
                .max(Comparator.comparingDouble(this::loyalGain))
                .map(Option::plan)
                .orElseGet(() -> dribble(0).plan);
    }

    private double loyalGain(Option option) {
        boolean same = (option.plan.action() == before.action() || (option.plan.isKick() && before.isKick()))
                && Math.abs(Angles.wrap(option.plan.headingDegrees() - before.headingDegrees())) < SAME_DEGREES;
        return option.gain + (same ? LOYALTY * Math.abs(option.gain) : 0);
    }

    /** {@return all options, for use in drawings} */
    public List<Option> options() {
        return options;
    }

    private List<Option> all() {
        List<Option> all = new ArrayList<>();
        for (double degrees = -180; degrees < 180; degrees += STEP_DEGREES) {
            add(all, degrees);
        }
        add(all, world.theirGoal().minus(world.ball()).degrees());
        return List.copyOf(all);
    }

    /** Adds the options that move the ball in one direction. */
    private void add(List<Option> all, double degrees) {
        if (!world.abilities().movesLegs()) {
            all.add(dribble(degrees));
            return;
        }
        if (mayDribble) {
            all.add(dribble(degrees));
        }
        for (KickKind kind : KickKind.values()) {
            if (kind.isFor(world.type())) {
                all.add(kick(kind, degrees));
            }
        }
    }

    private Option dribble(double degrees) {
        Translation2d end = world.ball().plus(Translation2d.polar(degrees, DRIBBLE_METRES));
        double seconds = DRIBBLE_METRES / DRIBBLE_SPEED + Footwork.aroundSeconds(world, degrees);
        double keeps = 1;
        for (Translation2d opponent : world.opponents()) {
            double near = opponent.distanceToSegment(world.ball(), end);
            keeps *= 1 - 0.5 * PortableMath.exp(-near * near);
        }
        Plan plan = new Plan(TeamRole.STRIKER, Plan.Action.DRIBBLE, end, degrees, 0);
        boolean near = world.ball().distanceTo(world.theirGoal()) < TAP_IN_METRES;
        double goal = near ? goalProbability(KickKind.QUICK, world.ball(), degrees) : 0;
        double score = goal * (1 - value(world.ball())) / seconds;
        return new Option(plan, orLost(keeps, score + (1 - goal) * gain(end, 1, seconds)));
    }

    private Option kick(KickKind kind, double degrees) {
        Translation2d ball = world.ball();
        Translation2d end = ball.plus(Translation2d.polar(degrees, kind.metres()));
        double seconds = Kick.seconds(world, degrees, kind);
        double free = freeLane(kind, ball, end);
        double goal = goalProbability(kind, ball, degrees);
        Optional<Mate> receiver = nearest(end);
        double reach = PASS_SHARE * kind.metres() + SetPlay.patienceSeconds(world) * RUN_SPEED;
        Optional<Mate> partner = receiver.filter(mate -> mate.place().distanceTo(end) < reach);
        double patience = partner.isPresent() ? SetPlay.patienceSeconds(world) : 0;
        double ours = secondsTo(receiver.map(Mate::place).orElse(world.place()), end, patience);
        double theirs = opponentDistance(end) / OPPONENT_SPEED;
        double keeps = probability(theirs - ours);
        double rest = isSetPlay()
                ? setPlayGain(end, free * keeps)
                : orLost(free, gain(end, keeps, seconds + runShare(kind) * ours));
        double shot = free * (1 - value(ball)) / seconds;
        int number = goal < 0.3 ? partner.map(Mate::number).orElse(0) : 0;
        Plan.Action action = kind == KickKind.FAR ? Plan.Action.FAR_KICK : Plan.Action.KICK;
        Plan plan = new Plan(TeamRole.STRIKER, action, end, degrees, number);
        return new Option(plan, orLost(undisturbed(seconds), goal * shot + (1 - goal) * rest));
    }

    /**
     * Returns the expected gain per second of an option that succeeds with some probability, and otherwise loses the ball, which
     * is never better.
     */
    private static double orLost(double succeeds, double gain) {
        return succeeds * gain + (1 - succeeds) * Math.min(gain, -LOSS / LOSS_SECONDS);
    }

    /**
     * Returns the distance to the nearest opponent. At a kick-off, opponents that the robot does not see may be anywhere in their
     * half.
     */
    private double opponentDistance(Translation2d end) {
        double seen = world.opponentDistance(end);
        boolean kickOff = world.situation() == Situation.OUR_KICK_OFF;
        return kickOff ? Math.min(seen, Math.max(0, KICK_OFF_METRES - end.x())) : seen;
    }

    /** Returns whether the opponents have to stay away from the ball until this team plays it, and then another player. */
    private boolean isSetPlay() {
        return world.situation().isOurs() && !world.mates().isEmpty();
    }

    /**
     * Returns the gain of a kick in a set play. There is time, and the taker may not touch the ball again, so what counts most
     * is that a teammate is the next to play the ball.
     */
    private double setPlayGain(Translation2d end, double keeps) {
        double better = isOnPitch(end) ? value(end) - value(world.ball()) : -SET_PLAY_LOSS;
        return (keeps * better - (1 - keeps) * SET_PLAY_LOSS) / LOSS_SECONDS;
    }

    /**
     * Returns the probability that no opponent interferes within the given time; in pass mode and in set plays the referee
     * keeps opponents away.
     */
    private double undisturbed(double seconds) {
        if (world.situation() == Situation.OUR_PASS || isSetPlay()) {
            return 1;
        }
        double lead = world.opponentDistance(world.ball()) / OPPONENT_SPEED - seconds;
        return DISTURBED + (1 - DISTURBED) * probability(2 * lead);
    }

    /**
     * Returns the gain per second of moving the ball to a position, given the probability that the team keeps the ball there.
     * If the ball is lost, half of what it has gained is lost too.
     */
    private double gain(Translation2d end, double keeps, double seconds) {
        if (!isOnPitch(end)) {
            return -LOSS / LOSS_SECONDS;
        }
        double better = value(end) - value(world.ball());
        double kept = better > 0 ? 0.5 + 0.5 * keeps : 1;
        return (kept * better - (1 - keeps) * LOSS) / seconds;
    }

    /**
     * Returns the weight of the time that a player needs to reach the ball after a kick. If no opponents are near, the team
     * loses that time; otherwise it matters more to move the ball away from them. After a far kick, the run to the ball is so
     * long that a pass could have been played in the meantime, so all of the time counts.
     */
    private double runShare(KickKind kind) {
        boolean alone = world.opponentDistance(world.ball()) > ALONE_METRES;
        return alone || kind == KickKind.FAR ? 1 : SHARE_OF_RUN;
    }

    private boolean isOnPitch(Translation2d spot) {
        return Math.abs(spot.x()) < world.field().length() / 2 - 0.3
                && Math.abs(spot.y()) < world.field().width() / 2 - 0.3;
    }

    /**
     * Returns the value of a ball position.
     *
     * @param spot the position
     * @return from −1 in the team's own goal to 1 in the opponents' goal
     */
    public double value(Translation2d spot) {
        return PortableMath.exp(-spot.distanceTo(world.theirGoal()) / VALUE_METRES)
                - PortableMath.exp(-spot.distanceTo(world.ourGoal()) / VALUE_METRES);
    }

    /**
     * Returns the probability that an unobstructed kick scores: 0 if the goal is out of range or the ball would pass over
     * the crossbar.
     */
    private double goalProbability(KickKind kind, Translation2d ball, double degrees) {
        double metres = ball.distanceTo(world.theirGoal());
        double post = world.field().goalWidth() / 2 - 0.1;
        Translation2d left = new Translation2d(world.theirGoal().x(), post).minus(ball);
        Translation2d right = new Translation2d(world.theirGoal().x(), -post).minus(ball);
        if (!mayScore || metres > kind.metres() || kind.isHigh(metres) || left.x() <= 0) {
            return 0;
        }
        double toLeft = Angles.wrap(left.degrees() - degrees) / SHOT_DEVIATION_DEGREES;
        double toRight = Angles.wrap(degrees - right.degrees()) / SHOT_DEVIATION_DEGREES;
        return probability(1.7 * toLeft) * probability(1.7 * toRight);
    }

    /**
     * Returns the probability that no robot stops the ball. Kicks deviate, so the lane widens with distance. A high ball passes
     * over most robots.
     */
    private double freeLane(KickKind kind, Translation2d from, Translation2d to) {
        double free = 1;
        for (Translation2d opponent : world.opponents()) {
            double lane = LANE_METRES + LANE_SLOPE * opponent.distanceTo(from);
            double near = opponent.distanceToSegment(from, to) / lane;
            double stops = kind.isHigh(opponent.distanceTo(from)) ? STOPS_HIGH : STOPS;
            free *= 1 - stops * PortableMath.exp(-near * near);
        }
        return free;
    }

    private Optional<Mate> nearest(Translation2d end) {
        return world.mates().stream()
                .filter(mate -> !mate.message().fallen() && !Roles.isKeeper(world, mate.number()))
                .min(Comparator.comparingDouble(mate -> mate.place().distanceTo(end)))
                .filter(mate -> isSetPlay()
                        || mate.place().distanceTo(end) < world.place().distanceTo(end));
    }

    private static double secondsTo(Translation2d from, Translation2d to, double patience) {
        return Math.max(1.5, from.distanceTo(to) / RUN_SPEED - patience);
    }

    /** Converts a lead, relative to its uncertainty, to a probability of success (logistic function). */
    private static double probability(double lead) {
        return 1 / (1 + PortableMath.exp(-lead));
    }
}

package org.robonewbie.team.tactics;

import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.team.skill.Goalkeeping;
import org.robonewbie.team.tactics.Plan.Action;
import org.robonewbie.team.talk.TeamMessage;
import org.robonewbie.team.talk.TeamRole;
import org.robonewbie.team.world.Situation;
import org.robonewbie.team.world.WorldModel;

/**
 * Makes a player's decisions once per camera image: {@link Roles} assigns its role; then {@link KickChoice} chooses the action
 * of a striker, or {@link Formation} the position of any other player. {@link SetPlay} adds the rules of set plays.
 */
public final class Strategy {

    private static final double LOST_SECONDS = 3;
    private static final double KEEPER_LOST_SECONDS = 1;
    private static final double KEEPER_LEAVES_METRES = 3.5;
    private static final double GET_UP_SECONDS = 4;
    private static final double BLIND_SECONDS = 1.5;
    private static final double SPEED = 0.5;
    private static final double TURN_SPEED = 90;
    private static final double NEAR_METRES = 0.8;
    private static final double KICK_LASTS_SECONDS = 5;
    private static final double PASS_SECONDS = 2;
    private static final double BESIDE_METRES = 0.4;
    private static final double MAX_TURNED_DEGREES = 90;

    private final WorldModel world;
    private final SetPlay setPlay = new SetPlay();
    private Plan plan = Plan.NONE;
    private List<KickChoice.Option> options = List.of();
    private double planSeconds;

    /**
     * Creates a strategy.
     *
     * @param world the world model
     */
    public Strategy(WorldModel world) {
        this.world = world;
    }

    /** {@return the current plan} */
    public Plan plan() {
        return plan;
    }

    /** {@return the striker's options at its last decision} */
    public List<KickChoice.Option> options() {
        return options;
    }

    /**
     * Returns what the player tells its teammates.
     *
     * @param told its plan
     * @return the message
     */
    public TeamMessage message(Plan told) {
        return new TeamMessage(
                world.number(),
                world.pose(),
                world.isFallen(),
                told.role(),
                world.ball(),
                world.ballVelocity(),
                world.ownBallAgeSeconds(),
                secondsToBall(),
                told.receiver(),
                told.target());
    }

    /** Updates the plan. */
    public void decide() {
        setPlay.update(world, plan.role());
        TeamRole role = new Roles(world, plan.role(), secondsToBall()).own();
        Plan next = planOf(role);
        if (!plan.kicksNow() || isOld(next)) {
            plan = next;
            planSeconds = world.seconds();
        }
    }

    /**
     * Returns whether the current plan may be replaced. A player that is preparing a kick keeps its plan for a while,
     * because each change requires additional steps.
     */
    private boolean isOld(Plan next) {
        return world.seconds() - planSeconds > KICK_LASTS_SECONDS
                || next.action() == Action.WAIT
                || next.role() != TeamRole.STRIKER
                || world.ballFromHere().length() > NEAR_METRES;
    }

    private Plan planOf(TeamRole role) {
        if (world.ballAgeSeconds() > (Roles.keepsAlone(world) ? KEEPER_LOST_SECONDS : LOST_SECONDS)) {
            return new Plan(role, Action.SEARCH, world.place(), 0, 0);
        }
        if (world.situation() == Situation.OVER) {
            return new Plan(role, Action.STAND, world.place(), 0, 0);
        }
        return switch (role) {
            case STRIKER -> striker();
            case KEEPER -> keeper();
            default -> waiting(role);
        };
    }

    private Plan keeper() {
        Translation2d place = Goalkeeping.place(world);
        double toBall = world.ball().minus(world.place()).degrees();
        double heading = Roles.keepsAlone(world) ? toBall : facing(place);
        return new Plan(TeamRole.KEEPER, Action.KEEP, place, heading, 0);
    }

    private Plan striker() {
        if (world.situation().isTheirs()) {
            Translation2d place = SetPlay.wall(world);
            return new Plan(TeamRole.STRIKER, Action.GO, place, facing(place), 0);
        }
        boolean kickOnly = setPlay.mayTouchOnce(world) || world.situation() == Situation.OUR_PASS;
        KickChoice choice = new KickChoice(world, !kickOnly, setPlay.mayScore(world), plan);
        options = choice.options();
        Plan best = choice.best();
        return setPlay.waitsForReceiver(world, best) ? best.with(Action.WAIT) : best;
    }

    private Plan waiting(TeamRole role) {
        Translation2d place = passTarget().orElseGet(() -> new Formation(world.field()).place(role, world.ball()));
        Translation2d legal = SetPlay.legal(world, place);
        return new Plan(role, Action.GO, legal, facing(legal), 0);
    }

    /** Returns the position for receiving a pass that a teammate has announced to this player; empty if there is none. */
    private Optional<Translation2d> passTarget() {
        return world.mates().stream()
                .filter(mate -> mate.message().receiver() == world.number())
                .filter(mate -> world.seconds() - mate.heardSeconds() < PASS_SECONDS)
                .map(mate -> mate.message().passTarget())
                .map(this::behind)
                .findFirst();
    }

    /**
     * Returns the position for receiving a ball: between the ball's target and the team's own goal, and beside the line that
     * connects them.
     */
    private Translation2d behind(Translation2d end) {
        Translation2d back = world.ourGoal().minus(end);
        Translation2d behind = end.towards(world.ourGoal(), BESIDE_METRES);
        Translation2d aside =
                new Translation2d(-back.y(), back.x()).times(BESIDE_METRES / Math.max(BESIDE_METRES, back.length()));
        Translation2d left = behind.plus(aside);
        Translation2d right = behind.minus(aside);
        return left.distanceTo(world.place()) < right.distanceTo(world.place()) ? left : right;
    }

    /**
     * Returns the heading of a waiting player: towards the ball, but never facing away from the opponents' goal, towards which
     * it will play the ball.
     */
    private double facing(Translation2d place) {
        double goal = world.theirGoal().minus(place).degrees();
        double turned = Angles.wrap(world.ball().minus(place).degrees() - goal);
        return goal + Math.max(-MAX_TURNED_DEGREES, Math.min(MAX_TURNED_DEGREES, turned));
    }

    /**
     * Estimates the time until the player could play the ball, based on the point at which it intercepts the rolling ball
     * and the turns required to get there.
     *
     * @return time in seconds; more than the robot's {@code maxSeconds} if the player does not claim the ball
     */
    public double secondsToBall() {
        boolean keeps = Roles.isKeeper(world, world.number())
                && world.ball().distanceTo(world.ourGoal()) > KEEPER_LEAVES_METRES;
        if (keeps || world.ballAgeSeconds() > LOST_SECONDS || setPlay.isForbidden()) {
            return world.abilities().maxSeconds() + 1;
        }
        double seconds = reachSeconds();
        Translation2d ball = world.ballIn(seconds);
        double behind = Math.abs(Angles.wrap(world.theirGoal().minus(ball).degrees()
                - ball.minus(world.place()).degrees()));
        double turn = Math.abs(ball.seenFrom(world.pose()).degrees());
        boolean blind = world.ownBallAgeSeconds() > BLIND_SECONDS;
        double sum =
                seconds + behind / TURN_SPEED + turn / TURN_SPEED + (world.isFallen() || blind ? GET_UP_SECONDS : 0);
        return Math.min(world.abilities().maxSeconds(), sum);
    }

    private double reachSeconds() {
        double step = 0.2;
        for (double seconds = 0; seconds < 4; seconds += step) {
            if (world.place().distanceTo(world.ballIn(seconds)) < SPEED * seconds) {
                return seconds;
            }
        }
        return world.place().distanceTo(world.ballIn(4)) / SPEED;
    }
}

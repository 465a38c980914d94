package org.robonewbie.team.tactics;

import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.team.skill.KickKind;
import org.robonewbie.team.talk.TeamRole;
import org.robonewbie.team.world.Mate;
import org.robonewbie.team.world.Situation;
import org.robonewbie.team.world.WorldModel;

/**
 * Rules for kick-offs, kick-ins, corners, goal kicks and free kicks. The taker of a kick must not touch the ball again before
 * another player has touched it, so it kicks far instead of dribbling, and then leaves the ball to the others. While the
 * opponents take a kick, all players keep away from the ball.
 */
public final class SetPlay {

    private static final double TAKER_METRES = 0.7;
    private static final double FORBIDDEN_SECONDS = 15;
    private static final double SETTLED_SECONDS = 1;
    private static final double LATER_SECONDS = 3;
    private static final double MOVED_METRES = 0.4;
    private static final double OTHERS_METRES = 0.5;
    private static final double KEEP_AWAY_METRES = 0.6;
    private static final double PATIENCE_SECONDS = 11;
    private static final double WAIT_SECONDS = 9;
    private static final double READY_METRES = 1;
    private static final double NO_GOAL_SECONDS = 10;
    private static final double SHOT_SECONDS = 2.5;
    private static final double ASK_METRES = 0.5;
    private static final double THREAT_METRES = 3;
    private static final double FAR_METRES = KickKind.QUICK.metres() + 1;

    private Situation before = Situation.LINE_UP;
    private double forbiddenUntil;
    private double noGoalUntil;
    private Translation2d end = Translation2d.ORIGIN;
    private boolean forbidden;

    /** Creates the state before the first kick-off. */
    public SetPlay() {}

    /**
     * Updates the state of the set play. Call this before each decision.
     *
     * @param world the world model
     * @param role the player's current role
     */
    public void update(WorldModel world, TeamRole role) {
        boolean taken = before.isOurs() && world.situation() == Situation.OPEN_PLAY;
        boolean taker = role == TeamRole.STRIKER && world.ball().distanceTo(world.place()) < TAKER_METRES;
        if (taken && taker && !world.mates().isEmpty()) {
            forbiddenUntil = world.seconds() + FORBIDDEN_SECONDS;
        }
        if (isForbidden(world) && forbiddenUntil - world.seconds() > FORBIDDEN_SECONDS - SETTLED_SECONDS) {
            end = world.ballIn(LATER_SECONDS);
        }
        if ((isForbidden(world) && isTouchedByOthers(world))
                || !world.situation().isOpen()) {
            forbiddenUntil = 0;
        }
        if (before == Situation.OUR_PASS && world.situation() == Situation.OPEN_PLAY) {
            noGoalUntil = world.seconds() + NO_GOAL_SECONDS;
        }
        forbidden = isForbidden(world);
        before = world.situation();
    }

    private boolean isForbidden(WorldModel world) {
        return world.seconds() < forbiddenUntil;
    }

    /**
     * Returns whether another robot has touched the ball: a robot is close, and the ball will come to rest elsewhere than
     * predicted.
     */
    private boolean isTouchedByOthers(WorldModel world) {
        boolean near = world.opponentDistance(world.ball()) < OTHERS_METRES
                || world.mates().stream()
                        .map(Mate::place)
                        .anyMatch(place -> place.distanceTo(world.ball()) < OTHERS_METRES);
        return near && world.ballIn(LATER_SECONDS).distanceTo(end) > MOVED_METRES;
    }

    /** {@return whether the player must not touch the ball, because it has just taken a kick} */
    public boolean isForbidden() {
        return forbidden;
    }

    /**
     * Returns whether a goal would count. For ten seconds after pass mode, a goal does not count unless two players of
     * the team have touched the ball; the time that the ball takes to reach the goal is taken into account. Kick-ins
     * and most free kicks are indirect.
     *
     * @param world the world model
     * @return whether a shot makes sense
     */
    public boolean mayScore(WorldModel world) {
        boolean indirect =
                world.situation() == Situation.OUR_KICK && !world.mates().isEmpty();
        return world.seconds() > noGoalUntil - SHOT_SECONDS && !indirect;
    }

    /**
     * Returns whether the player should request pass mode, which keeps opponents a metre away from the ball for four
     * seconds. This is the case if the player is about to pass, or to kick from a distance at which it cannot score, and an
     * opponent is approaching. A player without teammates does not pass. The referee decides whether to grant the request.
     *
     * @param world the world model
     * @param plan the player's plan
     * @return whether to request it
     */
    public static boolean wantsPass(WorldModel world, Plan plan) {
        boolean shot = plan.action() == Plan.Action.FAR_KICK
                && plan.target().x() > world.field().length() / 2;
        return plan.kicksNow()
                && !shot
                && !world.mates().isEmpty()
                && (plan.receiver() > 0 || world.ball().distanceTo(world.theirGoal()) > FAR_METRES)
                && world.situation() == Situation.OPEN_PLAY
                && world.ballFromHere().length() < ASK_METRES
                && world.opponentDistance(world.ball()) < THREAT_METRES;
    }

    /**
     * Returns whether the player is about to take a kick.
     *
     * @param world the world model
     * @return whether it may touch the ball only once; false once the time allowed for the kick has nearly elapsed
     */
    public boolean mayTouchOnce(WorldModel world) {
        return world.situation().isOurs() && !world.mates().isEmpty() && world.secondsInSituation() < PATIENCE_SECONDS;
    }

    /**
     * Returns whether the taker of a kick should wait for the receiver; opponents keep away in the meantime.
     *
     * @param world the world model
     * @param kick the player's plan
     * @return whether the receiver is still on its way
     */
    public boolean waitsForReceiver(WorldModel world, Plan kick) {
        return world.situation() == Situation.OUR_KICK
                && mayTouchOnce(world)
                && world.secondsInSituation() < WAIT_SECONDS
                && world.mates().stream()
                        .anyMatch(mate -> mate.number() == kick.receiver()
                                && mate.place().distanceTo(kick.target()) > READY_METRES);
    }

    /**
     * Returns the remaining time for which the taker of a kick can wait for the receiver.
     *
     * @param world the world model
     * @return time in seconds; 0 in open play
     */
    public static double patienceSeconds(WorldModel world) {
        return world.situation() == Situation.OUR_KICK ? Math.max(0, WAIT_SECONDS - world.secondsInSituation()) : 0;
    }

    /**
     * Returns the striker's position while the opponents take a kick: between the ball and the team's own goal, as close to the
     * ball as the rules allow.
     *
     * @param world the world model
     * @return the position
     */
    public static Translation2d wall(WorldModel world) {
        return world.ball().towards(world.ourGoal(), distance(world));
    }

    /**
     * Moves a position away from the ball if the opponents take a kick, and into the team's own half at a kick-off.
     *
     * @param world the world model
     * @param place the preferred position
     * @return the nearest legal position
     */
    public static Translation2d legal(WorldModel world, Translation2d place) {
        Situation situation = world.situation();
        boolean near = situation.isTheirs() && place.distanceTo(world.ball()) < distance(world);
        Translation2d away = near ? world.ball().towards(place, distance(world)) : place;
        boolean kickOff = situation == Situation.OUR_KICK_OFF || situation == Situation.THEIR_KICK_OFF;
        return kickOff && away.x() > -KEEP_AWAY_METRES ? new Translation2d(-KEEP_AWAY_METRES, away.y()) : away;
    }

    private static double distance(WorldModel world) {
        return world.field().centreCircleRadius() + KEEP_AWAY_METRES;
    }
}

package org.robonewbie.workshop.sparring;

import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.trial.WorldState;

/** Collects the figures of both teams from the true states of a match. Pass it the state of each cycle. */
final class MatchObserver {

    private static final Set<PlayMode> LINE_UP =
            EnumSet.of(PlayMode.BEFORE_KICK_OFF, PlayMode.GOAL_LEFT, PlayMode.GOAL_RIGHT, PlayMode.GAME_OVER);
    private static final Set<PlayMode> OPEN = EnumSet.of(PlayMode.PLAY_ON, PlayMode.PASS_LEFT, PlayMode.PASS_RIGHT);
    private static final double ROLLING_SECONDS = 0.677;
    private static final double TOUCH_METRES = 0.45;
    private static final double BEHIND_METRES = 0.2;
    private static final double TOUCH_SPEED = 0.15;

    /** Share of its speed by which a rolling ball slows down more in a cycle than a flying one. */
    private static final double FLIGHT = 0.04;

    private static final double KICK_SPEED = 1.5;
    private static final double GAIN_SECONDS = 4;
    private static final double HELD_METRES = 0.5;
    private static final double NEAR_BALL_METRES = 2.5;
    private static final double DANGER_METRES = 3;
    private static final double MOVING_SPEED = 0.2;
    private static final double MAX_SPEED = 3;
    private static final double HALF_LENGTH = 15;

    /** Cycles between two samples of all positions. */
    private static final int SAMPLE = 25;

    private final int home;
    private final TeamFigures left = new TeamFigures();
    private final TeamFigures right = new TeamFigures();
    private final boolean[] lying;
    private WorldState before;
    private WorldState sampled;
    private int cycle;
    private Optional<Kick> kick = Optional.empty();
    private Optional<Restart> restart = Optional.empty();

    private record Kick(int team, double x, double seconds) {}

    private record Restart(int team, int taker, boolean isKickOff) {}

    /**
     * Creates an observer.
     *
     * @param home number of players of the left team, which are the first robots
     * @param first the state before the match
     */
    MatchObserver(int home, WorldState first) {
        this.home = home;
        this.before = first;
        this.sampled = first;
        this.lying = new boolean[first.robots().size()];
    }

    TeamFigures left() {
        return left;
    }

    TeamFigures right() {
        return right;
    }

    void observe(WorldState now) {
        countGoals(now);
        countFalls(now);
        observeRestart(now);
        observeKick(now);
        cycle++;
        if (cycle % SAMPLE == 0) {
            sample(now);
            sampled = now;
        }
        before = now;
    }

    private TeamFigures figures(int team) {
        return team > 0 ? left : right;
    }

    private int team(int robot) {
        return robot < home ? 1 : -1;
    }

    private void countGoals(WorldState now) {
        left.add(Figure.GOALS, now.leftGoals() - before.leftGoals());
        right.add(Figure.GOALS, now.rightGoals() - before.rightGoals());
    }

    private void countFalls(WorldState now) {
        for (int i = 0; i < lying.length; i++) {
            BodyState robot = now.robots().get(i);
            if (robot.isFallen() && !lying[i]) {
                figures(team(i)).add(Figure.FALLS, 1);
            }
            lying[i] = robot.isFallen() || (lying[i] && !robot.isStanding());
        }
    }

    /** Counts who touches the ball next after a kick-off or another set play. */
    private void observeRestart(WorldState now) {
        int toucher = toucher(now);
        boolean taken = before.playMode().kicker().isPresent()
                && !OPEN.contains(before.playMode())
                && now.playMode() == PlayMode.PLAY_ON;
        if (taken) {
            int team = sign(before.playMode().kicker().get());
            boolean kickOff = isKickOff(before.playMode());
            figures(team).add(kickOff ? Figure.KICK_OFFS : Figure.SET_PLAYS, 1);
            restart = Optional.of(new Restart(team, nearest(now), kickOff));
        } else if (restart.isPresent()) {
            Restart play = restart.get();
            int next = toucher >= 0 && toucher != play.taker ? team(toucher) : 0;
            int awarded = OPEN.contains(now.playMode()) ? 0 : awarded(now.playMode());
            if (next != 0 || awarded != 0 || LINE_UP.contains(now.playMode())) {
                if (next == play.team || (next == 0 && awarded == play.team)) {
                    figures(play.team).add(play.isKickOff ? Figure.KICK_OFFS_KEPT : Figure.SET_PLAYS_KEPT, 1);
                }
                restart = Optional.empty();
            }
        }
    }

    private static boolean isKickOff(PlayMode mode) {
        return mode == PlayMode.KICK_OFF_LEFT || mode == PlayMode.KICK_OFF_RIGHT;
    }

    /** Returns the team that a play mode favours: 1 left, -1 right, 0 none. */
    private static int awarded(PlayMode mode) {
        return switch (mode) {
            case GOAL_LEFT -> 1;
            case GOAL_RIGHT -> -1;
            default -> mode.kicker().map(MatchObserver::sign).orElse(0);
        };
    }

    private static int sign(TeamSide side) {
        return side == TeamSide.LEFT ? 1 : -1;
    }

    private void observeKick(WorldState now) {
        double x = now.ball().x();
        if (kick.isPresent()) {
            Kick last = kick.get();
            boolean stopped = !OPEN.contains(now.playMode());
            if (stopped || now.seconds() - last.seconds >= GAIN_SECONDS) {
                double end = stopped ? before.ball().x() : x;
                figures(last.team).add(Figure.KICKED_METRES, last.team * (end - last.x));
                kick = Optional.empty();
            }
        }
        boolean faster = now.ballVelocity().length() > KICK_SPEED
                && before.ballVelocity().length() <= KICK_SPEED;
        int toucher = toucher(now);
        if (faster && toucher >= 0 && kick.isEmpty() && !LINE_UP.contains(now.playMode())) {
            figures(team(toucher)).add(Figure.KICKS, 1);
            kick = Optional.of(new Kick(team(toucher), before.ball().x(), now.seconds()));
        }
    }

    /**
     * Returns the index of the robot that has changed the ball's velocity in this cycle; −1 if none has. A robot pushes the ball
     * away from itself, so of two robots at the ball it is the one behind it.
     */
    private int toucher(WorldState now) {
        Vector3 rolling = before.ballVelocity().times(1 - Cycle.SECONDS / ROLLING_SECONDS);
        Vector3 push = now.ballVelocity().minus(rolling);
        boolean touched =
                push.length() > TOUCH_SPEED + FLIGHT * before.ballVelocity().length()
                        && now.ball().distanceTo(before.ball()) < 0.5;
        if (!touched) {
            return -1;
        }
        int nearest = nearest(now, before.ball().minus(push.times(BEHIND_METRES / push.length())));
        return nearest >= 0 && distance(now.robots().get(nearest), now.ball()) < TOUCH_METRES ? nearest : -1;
    }

    private static int nearest(WorldState now) {
        return nearest(now, now.ball());
    }

    private static int nearest(WorldState now, Vector3 place) {
        int nearest = -1;
        double least = Double.POSITIVE_INFINITY;
        List<BodyState> robots = now.robots();
        for (int i = 0; i < robots.size(); i++) {
            double metres = distance(robots.get(i), place);
            if (metres < least) {
                least = metres;
                nearest = i;
            }
        }
        return nearest;
    }

    private static double distance(BodyState robot, Vector3 ball) {
        return Math.hypot(robot.position().x() - ball.x(), robot.position().y() - ball.y());
    }

    private void sample(WorldState now) {
        if (LINE_UP.contains(now.playMode()) || LINE_UP.contains(sampled.playMode())) {
            return;
        }
        double seconds = SAMPLE * Cycle.SECONDS;
        sampleBall(now, 1, seconds);
        sampleBall(now, -1, seconds);
        int nearest = nearest(now);
        if (distance(now.robots().get(nearest), now.ball()) < HELD_METRES) {
            figures(team(nearest)).add(Figure.POSSESSION, seconds);
        }
        for (int i = 0; i < lying.length; i++) {
            BodyState robot = now.robots().get(i);
            if (distance(robot, now.ball()) < NEAR_BALL_METRES) {
                figures(team(i)).add(Figure.NEAR_BALL, seconds);
            }
            double speed = distance(robot, sampled.robots().get(i).position()) / seconds;
            if (!lying[i] && speed > MOVING_SPEED && speed < MAX_SPEED) {
                figures(team(i)).addSpeed(speed);
            }
        }
    }

    private void sampleBall(WorldState now, int team, double seconds) {
        double x = team * now.ball().x();
        figures(team).add(Figure.SECONDS, seconds);
        figures(team).add(Figure.TERRITORY, x * seconds);
        if (Math.hypot(x + HALF_LENGTH, now.ball().y()) < DANGER_METRES) {
            figures(team).add(Figure.DANGER, seconds);
        }
    }
}

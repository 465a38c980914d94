package org.robonewbie.workshop.sparring;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.robonewbie.agent.Options;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.soccer.SoccerParameter;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.team.Agent_Team;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;

/**
 * One half of a match on the league's pitch, on the game's clock, with restarts and noise. With an odd seed the first team plays
 * on the left, with an even seed on the right, where it does not have the first kick-off.
 *
 * @param first the first team
 * @param second the second team
 * @param seed seed of all noise
 * @param players number of players of each team
 * @param seconds length of the half in seconds
 */
record SparringMatch(SparringTeam first, SparringTeam second, long seed, int players, double seconds)
        implements Serializable {

    private static final double WAIT_SECONDS = 4;

    /** Result of a match. */
    record Result(SparringMatch match, TeamFigures first, TeamFigures second) {

        double goals() {
            return first.get(Figure.GOALS) - second.get(Figure.GOALS);
        }
    }

    /** Returns the part of a journal line that identifies the match. */
    String key() {
        return first.label() + " " + second.label() + " " + seed;
    }

    /** Plays the match. */
    Result play(Supplier<FrozenTeam> frozen) {
        boolean swapped = seed % 2 == 0 && second != SparringTeam.NOBODY; // a team alone is always the left one
        SparringTeam left = swapped ? second : first;
        SparringTeam right = swapped ? first : second;
        List<RobotStart> robots = new ArrayList<>();
        List<Controller> controllers = new ArrayList<>();
        int home = join(left, "Left", 1, frozen, robots, controllers);
        join(right, "Right", -1, frozen, robots, controllers);
        SoccerParameters rules = SoccerParameters.league()
                .with(SoccerParameter.AUTOMATIC_KICK_OFF, 1)
                .with(SoccerParameter.WAIT_BEFORE_KICK_OFF, WAIT_SECONDS)
                .with(SoccerParameter.SINGLE_HALF_TIME, 1)
                .with(SoccerParameter.RULE_HALF_TIME, seconds);
        Scene scene = new Scene(rules, true, Landscape.SOCCER, robots, Optional.of(Vector3.ZERO));
        try (Trial trial = Trial.served(scene, seed, controllers.toArray(Controller[]::new))) {
            trial.allowBeams();
            trial.order(new Order.SetTime(0));
            trial.order(new Order.ChangePlayMode(PlayMode.BEFORE_KICK_OFF));
            MatchObserver observer = new MatchObserver(home, trial.now());
            for (WorldState now = trial.step(); now.playMode() != PlayMode.GAME_OVER; now = trial.step()) {
                observer.observe(now);
            }
            return swapped
                    ? new Result(this, observer.right(), observer.left())
                    : new Result(this, observer.left(), observer.right());
        }
    }

    /** Adds the players of a team and returns their number. */
    private int join(
            SparringTeam team,
            String name,
            int side,
            Supplier<FrozenTeam> frozen,
            List<RobotStart> robots,
            List<Controller> controllers) {
        int number = team == SparringTeam.NOBODY ? 0 : players;
        for (int i = 1; i <= number; i++) {
            Pose2d pose = Options.none().pose(i);
            Pose2d place = new Pose2d(side * pose.x(), side * pose.y(), side > 0 ? 0 : 180);
            robots.add(new RobotStart(name, i, Agent_Team.type(i), place, List.of()));
            controllers.add(Controller.ofAgent(team.player(i, frozen)));
        }
        return number;
    }
}

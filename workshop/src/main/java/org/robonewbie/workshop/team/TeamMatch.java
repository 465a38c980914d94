package org.robonewbie.workshop.team;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.IntFunction;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.Options;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.soccer.SoccerParameter;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.team.Agent_Team;
import org.robonewbie.team.talk.TeamMessage;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;

/** One half of a match between two teams on the league pitch, and its statistics. */
final class TeamMatch {

    private static final double KICKED_METRES_PER_SECOND = 1.2;
    private static final double TOUCH_METRES = 0.35;
    private static final double WAIT_SECONDS = 4;
    private static final Set<PlayMode> IN_PLAY = EnumSet.of(PlayMode.PLAY_ON, PlayMode.PASS_LEFT, PlayMode.PASS_RIGHT);

    private final int home;
    private final List<Boolean> lying = new ArrayList<>();
    private final Trial trial;
    private final int[] receivers;
    private double ballSpeed;
    private Optional<Integer> passer = Optional.empty();
    private int falls;
    private int opponentsFalls;
    private int tried;
    private int reached;
    private int kicks;
    private WorldState now;

    /** Statistics of a half. */
    record Result(
            int goals, int against, int falls, int opponentsFalls, int kicks, int passesTried, int passesReached) {}

    private TeamMatch(int home, Trial trial) {
        this.home = home;
        this.trial = trial;
        this.receivers = new int[home];
        this.now = trial.now();
        now.robots().forEach(robot -> lying.add(false));
    }

    /**
     * Plays one half.
     *
     * @param seed seed for all noise
     * @param home number of players of the measured team
     * @param away number of players of the other team; may be 0
     * @param team creates a player of the measured team, given its uniform number
     * @param others creates a player of the other team, given its uniform number
     * @param halfSeconds length of the half in seconds
     */
    static Result play(
            long seed, int home, int away, IntFunction<Agent> team, IntFunction<Agent> others, double halfSeconds) {
        List<RobotStart> robots = new ArrayList<>();
        List<Controller> controllers = new ArrayList<>();
        for (int number = 1; number <= home; number++) {
            robots.add(robot("Team", number, 1));
            controllers.add(Controller.ofAgent(team.apply(number)));
        }
        for (int number = 1; number <= away; number++) {
            robots.add(robot("Others", number, -1));
            controllers.add(Controller.ofAgent(others.apply(number)));
        }
        SoccerParameters rules = SoccerParameters.league()
                .with(SoccerParameter.AUTOMATIC_KICK_OFF, 1)
                .with(SoccerParameter.WAIT_BEFORE_KICK_OFF, WAIT_SECONDS)
                .with(SoccerParameter.SINGLE_HALF_TIME, 1)
                .with(SoccerParameter.RULE_HALF_TIME, halfSeconds);
        Scene scene = new Scene(rules, true, Landscape.SOCCER, robots, Optional.of(Vector3.ZERO));
        try (Trial trial = Trial.served(scene, seed, controllers.toArray(Controller[]::new))) {
            trial.allowBeams();
            trial.order(new Order.SetTime(0));
            trial.order(new Order.ChangePlayMode(PlayMode.BEFORE_KICK_OFF));
            return new TeamMatch(home, trial).watch();
        }
    }

    private static RobotStart robot(String team, int number, int side) {
        Pose2d pose = Options.none().pose(number);
        Pose2d place = new Pose2d(side * pose.x(), side * pose.y(), side > 0 ? 0 : 180);
        return new RobotStart(team, number, Agent_Team.type(number), place, List.of());
    }

    private Result watch() {
        while (now.playMode() != PlayMode.GAME_OVER) {
            now = trial.step();
            countFalls();
            countPasses();
        }
        return new Result(now.leftGoals(), now.rightGoals(), falls, opponentsFalls, kicks, tried, reached);
    }

    private void countFalls() {
        for (int i = 0; i < lying.size(); i++) {
            boolean lies = now.robots().get(i).isFallen();
            if (lies && !lying.get(i)) {
                falls += i < home ? 1 : 0;
                opponentsFalls += i < home ? 0 : 1;
            }
            lying.set(i, lies || (lying.get(i) && !now.robots().get(i).isStanding()));
        }
    }

    private void countPasses() {
        for (int i = 0; i < home; i++) {
            int index = i;
            trial.said(i).flatMap(TeamMessage::decode).ifPresent(message -> receivers[index] = message.receiver());
        }
        double speed = now.ballVelocity().length();
        int nearest = nearest();
        boolean touched = nearest >= 0;
        boolean kicked = touched && nearest < home && speed > ballSpeed + KICKED_METRES_PER_SECOND;
        kicks += kicked ? 1 : 0;
        if (kicked && receivers[nearest] > 0) {
            tried++;
            passer = Optional.of(nearest);
        } else if (touched && passer.isPresent() && nearest != passer.get()) {
            reached += nearest < home ? 1 : 0;
            passer = Optional.empty();
        }
        passer = IN_PLAY.contains(now.playMode()) ? passer : Optional.empty();
        ballSpeed = speed;
    }

    /** Returns the index of the robot nearest to the ball; −1 if no robot can touch the ball. */
    private int nearest() {
        double[] metres = now.robots().stream()
                .mapToDouble(robot -> distance(robot, now.ball()))
                .toArray();
        double least = Arrays.stream(metres).min().orElse(Double.POSITIVE_INFINITY);
        for (int i = 0; i < metres.length; i++) {
            if (metres[i] == least && least < TOUCH_METRES) {
                return i;
            }
        }
        return -1;
    }

    private static double distance(BodyState robot, Vector3 ball) {
        return Math.hypot(robot.position().x() - ball.x(), robot.position().y() - ball.y());
    }
}

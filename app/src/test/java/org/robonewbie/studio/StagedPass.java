package org.robonewbie.studio;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.IntStream;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.AgentDriver;
import org.robonewbie.agent.Options;
import org.robonewbie.examples.Agent_BetterSoccer;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.telemetry.TelemetryMessage;
import org.robonewbie.protocol.telemetry.TelemetrySink;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.recording.RecordingTarget;
import org.robonewbie.simulator.soccer.SoccerParameter;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.team.Agent_Team;
import org.robonewbie.team.talk.TeamMessage;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.SensorReadings;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.TrialListener;

/**
 * A studio that shows a pass of the example team, for the picture in {@code docs/team/knowing.md}: a real match that has stopped when the
 * ball begins to roll to its receiver.
 */
final class StagedPass {

    private static final int PLAYERS = 5;
    private static final long SEED = 1;
    private static final double MAX_SECONDS = 300;
    private static final double MIN_SPEED = 3;
    private static final double READY_METRES = 0.8;
    private static final double ALONE_METRES = 0.9;
    private static final int CYCLES_AFTER = 2;

    private StagedPass() {}

    /** Prints the address of the studio, which shows the thoughts of the players as soon as its user pauses the match. */
    public static void main(String[] args) throws IOException, InterruptedException {
        MatchOnShow match = new MatchOnShow();
        try (StudioServer studio = StudioServer.start(match, 0, AccessToken.random());
                Trial trial = match.begin()) {
            playUntilFirstPass(match, trial);
            for (int i = 0; i < CYCLES_AFTER; i++) {
                match.step(trial);
            }
            match.show(trial, studio.telemetry());
            match.whenOrdered(() -> match.show(trial, studio.telemetry()));
            System.out.println("Watch it at " + studio.oneTimeAddress());
            Thread.currentThread().join();
        }
    }

    /** Plays until the ball has just left the foot of a player that passes it, and the receiver is ready. */
    private static void playUntilFirstPass(MatchOnShow match, Trial trial) {
        TeamMessage[] said = new TeamMessage[PLAYERS];
        while (trial.seconds() < MAX_SECONDS) {
            match.step(trial);
            for (int i = 0; i < PLAYERS; i++) {
                int index = i;
                trial.said(i).flatMap(TeamMessage::decode).ifPresent(message -> said[index] = message);
                if (said[i] != null && isPass(trial, i, said[i])) {
                    return;
                }
            }
        }
        throw new IllegalStateException("There was no pass within " + MAX_SECONDS + " s.");
    }

    private static boolean isPass(Trial trial, int player, TeamMessage said) {
        if (said.receiver() == 0 || trial.now().ballVelocity().length() < MIN_SPEED) {
            return false;
        }
        double rolled = trial.now().place(player).distance(trial.now().ball());
        Vector3 end = new Vector3(said.passTarget().x(), said.passTarget().y(), 0);
        Vector3 middle = new Vector3(
                (trial.now().ball().x() + end.x()) / 2, (trial.now().ball().y() + end.y()) / 2, 0);
        return isAlone(trial, player, trial.now().ball())
                && isAlone(trial, player, middle)
                && rolled > 0.4
                && rolled < 0.6
                && trial.now().place(said.receiver() - 1).distance(end) < READY_METRES;
    }

    /** Returns whether a place is free, except for the player that passes. */
    private static boolean isAlone(Trial trial, int player, Vector3 place) {
        return IntStream.range(0, 2 * PLAYERS)
                .filter(other -> other != player)
                .noneMatch(other -> trial.now().place(other).distance(place) < ALONE_METRES);
    }

    /** A match that is played cycle by cycle and can be shown in a studio. */
    private static final class MatchOnShow implements SimulationControl {

        private final List<SimulationObserver> observers = new CopyOnWriteArrayList<>();
        private final List<TelemetryMessage> thoughts = new ArrayList<>();
        private volatile Runnable ordered = () -> {};

        Trial begin() {
            List<RobotStart> robots = new ArrayList<>();
            for (int i = 0; i < 2 * PLAYERS; i++) {
                int side = i < PLAYERS ? 1 : -1;
                int number = i % PLAYERS + 1;
                Pose2d pose = Options.none().pose(number);
                Pose2d place = new Pose2d(side * pose.x(), side * pose.y(), side > 0 ? 0 : 180);
                String team = side > 0 ? "Team" : "Others";
                robots.add(new RobotStart(team, number, Agent_Team.type(number), place, List.of()));
            }
            SoccerParameters rules = SoccerParameters.league()
                    .with(SoccerParameter.AUTOMATIC_KICK_OFF, 1)
                    .with(SoccerParameter.WAIT_BEFORE_KICK_OFF, 4);
            Trial trial = Trial.observed(
                    new Scene(rules, true, Landscape.SOCCER, robots, Optional.of(Vector3.ZERO)),
                    SEED,
                    TrialListener.NONE,
                    RecordingTarget.NONE,
                    start -> start.team().equals("Team")
                            ? new ShownPlayer(new Agent_Team(start.number()), thoughts::add)
                            : Controller.ofAgent(new Agent_BetterSoccer()));
            trial.allowBeams();
            trial.order(new Order.SetTime(0));
            trial.order(new Order.ChangePlayMode(PlayMode.BEFORE_KICK_OFF));
            return trial;
        }

        /** Plays one cycle, whose thoughts replace those of the cycle before. */
        void step(Trial trial) {
            thoughts.clear();
            trial.step();
        }

        /** Shows the cycle and what the players thought in it. */
        void show(Trial trial, TelemetrySink viewer) {
            observers.forEach(observer -> observer.cycleEnded(trial.snapshot(false, 1)));
            thoughts.forEach(viewer::accept);
        }

        void whenOrdered(Runnable action) {
            ordered = action;
        }

        @Override
        public SoccerField field() {
            return SoccerField.LEAGUE;
        }

        @Override
        public void order(Order order) {
            ordered.run();
        }

        @Override
        public void addObserver(SimulationObserver observer) {
            observers.add(observer);
        }

        @Override
        public void removeObserver(SimulationObserver observer) {
            observers.remove(observer);
        }
    }

    /** A player whose drawings can be seen. */
    private static final class ShownPlayer implements Controller {

        private final AgentDriver driver;

        ShownPlayer(Agent agent, TelemetrySink viewer) {
            driver = new AgentDriver(agent);
            driver.publishTo(viewer);
        }

        @Override
        public void introduce(String team, int number, TeamSide side) {
            driver.introduce(Options.none().withTeam(team).withNumber(number), side);
        }

        @Override
        public List<EffectorCommand> respond(SensorReadings readings) {
            return driver.respond(readings.message());
        }
    }
}

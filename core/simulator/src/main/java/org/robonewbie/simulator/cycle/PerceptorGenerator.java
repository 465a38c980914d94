package org.robonewbie.simulator.cycle;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.model.Hinge;
import org.robonewbie.protocol.perceptor.GameState;
import org.robonewbie.protocol.perceptor.JointAngles;
import org.robonewbie.protocol.perceptor.JointAngles.ExtraHinge;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.Vision;
import org.robonewbie.simulator.sensing.VisiblePlayer;
import org.robonewbie.simulator.soccer.Match;
import org.robonewbie.simulator.soccer.Player;
import org.robonewbie.simulator.soccer.SoccerParameter;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.simulator.world.SoccerWorld;

/** Generates the perceptor messages of robots at the end of a cycle. */
final class PerceptorGenerator {

    private final SoccerWorld world;
    private final Match match;

    PerceptorGenerator(SoccerWorld world, Match match) {
        this.world = world;
        this.match = match;
    }

    /**
     * Captures the images of all cameras. As in SimSpark, they show the world after the physics step and before the
     * referee moves anything.
     */
    void takePictures(List<AgentSession> agents) {
        List<VisiblePlayer> players = isPictureDue(agents) ? visiblePlayers() : List.of();
        for (AgentSession agent : agents) {
            agent.setPicture(picture(agent, players));
        }
    }

    private static boolean isPictureDue(List<AgentSession> agents) {
        for (AgentSession agent : agents) {
            if (agent.seesInThisCycle()) {
                return true;
            }
        }
        return false;
    }

    private List<VisiblePlayer> visiblePlayers() {
        List<VisiblePlayer> players = new ArrayList<>();
        for (Player player : match.teams().players()) {
            players.add(new VisiblePlayer(player.robot(), player.team().name(), player.number()));
        }
        return players;
    }

    private Optional<Vision> picture(AgentSession agent, List<VisiblePlayer> players) {
        if (!agent.seesInThisCycle()
                || agent.robot().isEmpty()
                || agent.camera().isEmpty()
                || isUnidentified(agent)) {
            return Optional.empty();
        }
        Optional<TeamSide> side = agent.player().map(Player::side);
        return Optional.of(agent.camera().get().look(agent.robot().get(), world, players, side));
    }

    /**
     * Returns whether an awaited agent has not yet joined a team. Until then it sees nothing, because its view would
     * depend on the order in which agents connect.
     */
    private static boolean isUnidentified(AgentSession agent) {
        return agent.connection().isAwaited() && agent.player().isEmpty();
    }

    PerceptorMessage of(AgentSession agent, Robot robot, double seconds) {
        double playSeconds = match.state().playSeconds();
        boolean labelled = match.parameters().isOn(SoccerParameter.LABEL_MESSAGES);
        return new PerceptorMessage(
                OptionalDouble.of(seconds),
                Optional.of(gameState(agent, playSeconds)),
                agent.hearing().collect(playSeconds, labelled),
                Optional.of(robot.gyroDegreesPerSecond()),
                Optional.of(robot.acceleration()),
                JointAngles.measured(robot::jointDegrees, toes(robot)),
                robot.footForces(),
                agent.picture());
    }

    private GameState gameState(AgentSession agent, double playSeconds) {
        boolean reportsScore = match.parameters().isOn(SoccerParameter.REPORT_SCORE);
        Optional<Player> announced = agent.takeTeamAnnouncement() ? agent.player() : Optional.empty();
        return new GameState(
                announced.isPresent() ? OptionalInt.of(announced.get().number()) : OptionalInt.empty(),
                announced.map(Player::side),
                reportsScore ? OptionalInt.of(match.state().score(TeamSide.LEFT)) : OptionalInt.empty(),
                reportsScore ? OptionalInt.of(match.state().score(TeamSide.RIGHT)) : OptionalInt.empty(),
                playSeconds,
                match.state().playMode().simSparkName());
    }

    private static List<ExtraHinge> toes(Robot robot) {
        if (!robot.type().hasToes()) {
            return List.of();
        }
        List<ExtraHinge> toes = new ArrayList<>();
        List<Hinge> hinges = robot.nao().hinges();
        for (int i = 0; i < hinges.size(); i++) {
            String name = hinges.get(i).perceptorName();
            if (name.endsWith("j7")) {
                toes.add(new ExtraHinge(name, robot.jointDegrees(i)));
            }
        }
        return toes;
    }
}

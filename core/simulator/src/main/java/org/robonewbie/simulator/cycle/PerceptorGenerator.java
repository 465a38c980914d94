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

/** Asks all perceptors of a robot at the end of a cycle. */
final class PerceptorGenerator {

    private final SoccerWorld world;
    private final Match match;

    PerceptorGenerator(SoccerWorld world, Match match) {
        this.world = world;
        this.match = match;
    }

    /**
     * Takes the pictures of all cameras. As in SimSpark they see the world as its step has left it, before the referee moves
     * anything.
     */
    void takePictures(List<AgentSession> agents) {
        List<VisiblePlayer> players = isAnybodyLooking(agents) ? visiblePlayers() : List.of();
        for (AgentSession agent : agents) {
            agent.setPicture(picture(agent, players));
        }
    }

    private static boolean isAnybodyLooking(List<AgentSession> agents) {
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
                || isStillNobody(agent)) {
            return Optional.empty();
        }
        Optional<TeamSide> side = agent.player().map(Player::side);
        return Optional.of(agent.camera().get().look(agent.robot().get(), world, players, side));
    }

    /** What an awaited agent sees from where its robot happened to appear would depend on who came first. */
    private static boolean isStillNobody(AgentSession agent) {
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
        boolean tellTeam = agent.takeTeamToBeTold();
        boolean tellScore = match.parameters().isOn(SoccerParameter.REPORT_SCORE);
        Optional<Player> told = tellTeam ? agent.player() : Optional.empty();
        return new GameState(
                told.isPresent() ? OptionalInt.of(told.get().number()) : OptionalInt.empty(),
                told.map(Player::side),
                tellScore ? OptionalInt.of(match.state().score(TeamSide.LEFT)) : OptionalInt.empty(),
                tellScore ? OptionalInt.of(match.state().score(TeamSide.RIGHT)) : OptionalInt.empty(),
                playSeconds,
                match.state().playMode().simSparkName());
    }

    private static List<ExtraHinge> toes(Robot robot) {
        if (!robot.model().type().hasToes()) {
            return List.of();
        }
        List<ExtraHinge> toes = new ArrayList<>();
        List<Hinge> hinges = robot.model().hinges();
        for (int i = 0; i < hinges.size(); i++) {
            String name = hinges.get(i).perceptorName();
            if (name.endsWith("j7")) {
                toes.add(new ExtraHinge(name, robot.jointDegrees(i)));
            }
        }
        return toes;
    }
}

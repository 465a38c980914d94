package org.robonewbie.simulator.soccer;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.protocol.monitor.Foul;
import org.robonewbie.protocol.monitor.FoulType;
import org.robonewbie.protocol.order.PlayerNumber;

/**
 * Calls fouls in each cycle and enforces penalties (SimSpark: {@code soccerruleaspect.cpp}).
 *
 * <p>A punished robot is held in the air for a short time and then placed beside the pitch. Until then, it cannot be
 * punished again.
 */
final class Referee implements Memory {

    private static final int MAX_FOULS = 200;
    private static final double LIFTED_HEIGHT = 1.0;
    private static final double LIFT_PER_TICK = 0.01;

    private final Match match;
    private final List<FoulRule> rules;
    private final List<Foul> fouls = new ArrayList<>();
    private int foulCount;

    Referee(Match match) {
        this.match = match;
        this.rules = List.of(
                new CrowdingRule(match),
                new IllegalDefenceRule(match),
                new IncapableRule(match),
                new TouchingRule(match),
                new ChargingRule(match),
                new SelfCollisionRule(match));
    }

    void judge(boolean paused) {
        match.players()
                .forEach(player -> player.fouls().addVelocity(player.robot().torsoVelocity()));
        if (paused) {
            match.players().forEach(player -> player.fouls().forgiveFouls());
            return;
        }
        rules.forEach(FoulRule::judge);
        for (Player player : List.copyOf(match.players())) {
            player.fouls().punishedFor().ifPresent(foul -> penalize(player, foul));
        }
    }

    /** Returns the latest fouls in chronological order; a penalty is listed once per tick of its duration. */
    List<Foul> fouls() {
        return Collections.unmodifiableList(fouls);
    }

    /** Starts a penalty, which removes the player from the pitch. */
    void punish(Player player, FoulType foul) {
        if (!player.fouls().isPunished()) {
            player.fouls().punish(foul);
            match.addEvent(new MatchEvent.FoulCalled(foul, player.side(), player.number()));
        }
    }

    /** Reports a foul without a penalty. */
    void report(Player player, FoulType foul) {
        match.addEvent(new MatchEvent.FoulCalled(foul, player.side(), player.number()));
        add(player, foul);
    }

    /** Returns both sides in random order. */
    List<TeamSide> sides() {
        return match.random().nextBoolean()
                ? List.of(TeamSide.LEFT, TeamSide.RIGHT)
                : List.of(TeamSide.RIGHT, TeamSide.LEFT);
    }

    private void add(Player player, FoulType foul) {
        foulCount++;
        fouls.add(new Foul(foulCount, foul, new PlayerNumber(player.side(), player.number())));
        if (fouls.size() > MAX_FOULS) {
            fouls.remove(0);
        }
    }

    private void penalize(Player player, FoulType foul) {
        double holdSeconds = match.parameters().get(SoccerParameter.FOUL_HOLD_TIME);
        int ticks = player.fouls().countPenalty();
        player.fouls().moved(match.currentTick());
        if (ticks * Cycle.SECONDS <= holdSeconds) {
            add(player, foul);
            Vector3 position = player.position();
            player.robot().moveTo(new Vector3(position.x(), position.y(), LIFTED_HEIGHT + LIFT_PER_TICK * ticks));
            return;
        }
        double height = holdSeconds == 0 ? LIFTED_HEIGHT : match.parameters().get(SoccerParameter.AGENT_RADIUS);
        player.robot().moveTo(Spots.besidePitch(match, player).plus(new Vector3(0, 0, height)));
        player.fouls().forgiveFouls();
    }

    static Optional<Player> nearest(List<Player> players, Vector3 point, int rank) {
        return players.stream()
                .sorted(Comparator.comparingDouble(player -> flatDistance(player, point)))
                .skip(rank)
                .findFirst();
    }

    static double flatDistance(Player player, Vector3 point) {
        return PortableMath.hypot(
                player.position().x() - point.x(), player.position().y() - point.y());
    }

    @Override
    public void save(StateWriter out, Roster roster) {
        out.putInt(foulCount);
        out.putAll(fouls, foul -> {
            out.putInt(foul.index());
            out.putEnum(foul.type());
            out.putEnum(foul.player().side());
            out.putInt(foul.player().number());
        });
        rules.forEach(rule -> rule.save(out, roster));
    }

    @Override
    public void restore(StateReader in, Roster roster) {
        foulCount = in.getInt();
        fouls.clear();
        fouls.addAll(in.getAll(() -> new Foul(
                in.getInt(),
                in.getEnum(FoulType.values()),
                new PlayerNumber(in.getEnum(TeamSide.values()), in.getInt()))));
        rules.forEach(rule -> rule.restore(in, roster));
    }
}

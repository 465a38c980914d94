package org.robonewbie.simulator.soccer;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.protocol.monitor.FoulType;
import org.robonewbie.simulator.world.RobotContact;

/** A robot that runs into an opponent instead of going for the ball is sent off the pitch. */
final class ChargingRule implements FoulRule {

    private static final double MOVED_SECONDS = 1;

    private final Match match;
    private final SoccerParameters parameters;
    private final Map<Pair, Long> lastCollisions = new LinkedHashMap<>();

    ChargingRule(Match match) {
        this.match = match;
        this.parameters = match.parameters();
    }

    private record Pair(Player left, Player right) {}

    @Override
    public void judge() {
        if (!parameters.isOn(SoccerParameter.USE_CHARGING)) {
            return;
        }
        Set<Pair> seen = new HashSet<>();
        for (RobotContact contact : match.robotContacts()) {
            pair(contact).filter(seen::add).ifPresent(pair -> collide(pair, contact.position()));
        }
        lastCollisions
                .keySet()
                .removeIf(pair -> since(lastCollisions.getOrDefault(pair, FoulHistory.NEVER))
                        > parameters.get(SoccerParameter.CHARGING_COLLISION_MIN_TIME));
    }

    private Optional<Pair> pair(RobotContact contact) {
        Optional<Player> first = match.playerOf(contact.first().robot());
        Optional<Player> second = match.playerOf(contact.second().robot());
        if (first.isEmpty()
                || second.isEmpty()
                || first.get().side() == second.get().side()) {
            return Optional.empty();
        }
        boolean inOrder = first.get().side() == TeamSide.LEFT;
        return Optional.of(inOrder ? new Pair(first.get(), second.get()) : new Pair(second.get(), first.get()));
    }

    private void collide(Pair pair, Vector3 place) {
        boolean isNew = !lastCollisions.containsKey(pair);
        lastCollisions.put(pair, match.currentTick());
        if (!isNew || !mayBeJudged(pair.left()) || !mayBeJudged(pair.right())) {
            return;
        }
        Approach left = new Approach(pair.left(), pair.right());
        Approach right = new Approach(pair.right(), pair.left());
        judge(left, right, place);
    }

    private boolean mayBeJudged(Player player) {
        return player.fouls().notStandingTicks() == 0
                && !player.fouls().isPunished()
                && since(player.fouls().movedTick()) > MOVED_SECONDS;
    }

    private void judge(Approach left, Approach right, Vector3 place) {
        boolean leftGuilty = isCandidate(left, right) && runsInto(left, place);
        boolean rightGuilty = isCandidate(right, left) && runsInto(right, place);
        boolean atBall = flat(place.minus(match.ball().position())).length()
                < parameters.get(SoccerParameter.CHARGING_MIN_COLLISION_BALL_DISTANCE);
        if (leftGuilty != rightGuilty && !atBall) {
            punish(leftGuilty ? left : right);
        }
    }

    /** Whether a robot went for the opponent rather than for the ball. */
    private boolean isCandidate(Approach robot, Approach other) {
        double range = parameters.get(SoccerParameter.CHARGING_MAX_BALL_RULES_DISTANCE);
        if (robot.ballDistance() > range && other.ballDistance() > range) {
            return true;
        }
        if (goesForOpponent(robot)) {
            return true;
        }
        return !goesForOpponent(other) && isWorse(robot, other);
    }

    private boolean goesForOpponent(Approach robot) {
        return robot.angleToBall() >= robot.angleToOpponent()
                && robot.angleToBall() >= parameters.get(SoccerParameter.CHARGING_MIN_BALL_SPEED_ANGLE)
                && robot.speed() >= parameters.get(SoccerParameter.CHARGING_MIN_SPEED);
    }

    /** Whether, of two robots that both went for the ball, this one came later. */
    private boolean isWorse(Approach robot, Approach other) {
        boolean farther = robot.ballDistance()
                > other.ballDistance() + parameters.get(SoccerParameter.CHARGING_MIN_DELTA_DISTANCE);
        boolean anglesDiffer = Math.abs(robot.angleToOpponent() - other.angleToOpponent())
                > parameters.get(SoccerParameter.CHARGING_MIN_DELTA_ANGLE);
        return farther && (anglesDiffer || other.speed() < parameters.get(SoccerParameter.CHARGING_MIN_SPEED));
    }

    private boolean runsInto(Approach robot, Vector3 place) {
        Vector3 target = place.plus(robot.opponent().position()).times(0.5);
        Vector3 way = flat(target.minus(robot.player().position()));
        double towards = way.length() == 0 ? 0 : robot.velocity().dot(way) / way.length();
        return robot.speed() >= parameters.get(SoccerParameter.CHARGING_MIN_SPEED)
                && towards >= parameters.get(SoccerParameter.CHARGING_MIN_COLLISION_SPEED);
    }

    private void punish(Approach robot) {
        Player player = robot.player();
        if (since(player.fouls().chargingImmunityTick()) <= parameters.get(SoccerParameter.CHARGING_IMMUNITY_TIME)) {
            robot.opponent().fouls().protectFromCharging(match.currentTick());
        } else if (!(player.isGoalkeeper() && isBehindOrInOwnArea(player)) && !isHuntingInKeepaway(player)) {
            match.referee().punish(player, FoulType.CHARGING);
        }
    }

    /** In keep-away the right team may go for the ball as it likes. */
    private boolean isHuntingInKeepaway(Player player) {
        return parameters.isOn(SoccerParameter.KEEPAWAY) && player.side() == TeamSide.RIGHT;
    }

    private boolean isBehindOrInOwnArea(Player player) {
        Area area = match.penaltyArea(player.side());
        Vector3 position = player.position();
        boolean behind = player.side() == TeamSide.LEFT ? position.x() < area.maxX() : position.x() > area.minX();
        return behind && position.y() >= area.minY() && position.y() <= area.maxY();
    }

    private double since(long earlierTick) {
        return (match.currentTick() - earlierTick) * Cycle.SECONDS;
    }

    private static Vector3 flat(Vector3 vector) {
        return new Vector3(vector.x(), vector.y(), 0);
    }

    /** How one robot came to the collision. */
    private final class Approach {

        private final Player player;
        private final Player opponent;
        private final Vector3 velocity;

        Approach(Player player, Player opponent) {
            this.player = player;
            this.opponent = opponent;
            this.velocity = player.fouls().velocity();
        }

        Player player() {
            return player;
        }

        Player opponent() {
            return opponent;
        }

        Vector3 velocity() {
            return velocity;
        }

        double speed() {
            return velocity.length();
        }

        double ballDistance() {
            return Referee.flatDistance(player, match.ball().position());
        }

        double angleToBall() {
            return angle(match.ball().position());
        }

        double angleToOpponent() {
            return angle(opponent.position());
        }

        private double angle(Vector3 target) {
            Vector3 way = flat(target.minus(player.position()));
            double product = way.length() * velocity.length();
            return product == 0
                    ? 0
                    : PortableMath.toDegrees(PortableMath.acos(Math.max(-1, Math.min(1, way.dot(velocity) / product))));
        }
    }

    @Override
    public void save(StateWriter out, Roster roster) {
        out.putAll(lastCollisions.entrySet(), collision -> {
            roster.save(collision.getKey().left(), out);
            roster.save(collision.getKey().right(), out);
            out.putLong(collision.getValue());
        });
    }

    @Override
    public void restore(StateReader in, Roster roster) {
        lastCollisions.clear();
        for (int count = in.getCount(); count > 0; count--) {
            lastCollisions.put(new Pair(roster.restore(in), roster.restore(in)), in.getLong());
        }
    }
}

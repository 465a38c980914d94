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

/** Charging foul: a robot that runs into an opponent instead of going for the ball is removed from the pitch. */
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
        double minSeconds = parameters.get(SoccerParameter.CHARGING_COLLISION_MIN_TIME);
        lastCollisions.values().removeIf(tick -> since(tick) > minSeconds);
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

    private void collide(Pair pair, Vector3 contact) {
        boolean isNew = !lastCollisions.containsKey(pair);
        lastCollisions.put(pair, match.currentTick());
        if (!isNew || !mayBeJudged(pair.left()) || !mayBeJudged(pair.right())) {
            return;
        }
        Approach left = approach(pair.left(), pair.right());
        Approach right = approach(pair.right(), pair.left());
        judge(left, right, contact);
    }

    private boolean mayBeJudged(Player player) {
        return player.fouls().notStandingTicks() == 0
                && !player.fouls().isPunished()
                && since(player.fouls().movedTick()) > MOVED_SECONDS;
    }

    private void judge(Approach left, Approach right, Vector3 contact) {
        boolean leftGuilty = isCandidate(left, right) && runsInto(left, contact);
        boolean rightGuilty = isCandidate(right, left) && runsInto(right, contact);
        boolean atBall = flat(contact.minus(match.ball().position())).length()
                < parameters.get(SoccerParameter.CHARGING_MIN_COLLISION_BALL_DISTANCE);
        if (leftGuilty != rightGuilty && !atBall) {
            punish(leftGuilty ? left : right);
        }
    }

    /**
     * Returns whether a robot may be guilty: it approached the opponent rather than the ball, or would have reached the ball
     * later than the opponent, or both robots were far from the ball.
     */
    private boolean isCandidate(Approach robot, Approach other) {
        double range = parameters.get(SoccerParameter.CHARGING_MAX_BALL_RULES_DISTANCE);
        if (robot.ballDistance() > range && other.ballDistance() > range) {
            return true;
        }
        if (approachesOpponent(robot)) {
            return true;
        }
        return !approachesOpponent(other) && isLater(robot, other);
    }

    private boolean approachesOpponent(Approach robot) {
        return robot.angleToBall() >= robot.angleToOpponent()
                && robot.angleToBall() >= parameters.get(SoccerParameter.CHARGING_MIN_BALL_SPEED_ANGLE)
                && robot.speed() >= parameters.get(SoccerParameter.CHARGING_MIN_SPEED);
    }

    /** Returns whether a robot is expected to reach the ball later than the other robot. */
    private boolean isLater(Approach robot, Approach other) {
        boolean farther = robot.ballDistance()
                > other.ballDistance() + parameters.get(SoccerParameter.CHARGING_MIN_DELTA_DISTANCE);
        boolean anglesDiffer = Math.abs(robot.angleToOpponent() - other.angleToOpponent())
                > parameters.get(SoccerParameter.CHARGING_MIN_DELTA_ANGLE);
        return farther && (anglesDiffer || other.speed() < parameters.get(SoccerParameter.CHARGING_MIN_SPEED));
    }

    private boolean runsInto(Approach robot, Vector3 contact) {
        Vector3 target = contact.plus(robot.opponent().position()).times(0.5);
        Vector3 direction = flat(target.minus(robot.player().position()));
        double towards = direction.length() == 0 ? 0 : robot.velocity().dot(direction) / direction.length();
        return robot.speed() >= parameters.get(SoccerParameter.CHARGING_MIN_SPEED)
                && towards >= parameters.get(SoccerParameter.CHARGING_MIN_COLLISION_SPEED);
    }

    private void punish(Approach robot) {
        Player player = robot.player();
        if (since(player.fouls().chargingImmunityTick()) <= parameters.get(SoccerParameter.CHARGING_IMMUNITY_TIME)) {
            robot.opponent().fouls().protectFromCharging(match.currentTick());
        } else if (!(player.isGoalkeeper() && isBehindOrInOwnArea(player)) && !isKeepawayHunter(player)) {
            match.referee().punish(player, FoulType.CHARGING);
        }
    }

    /** Returns whether keep-away is being played and the player belongs to the right team, which is never punished for charging. */
    private boolean isKeepawayHunter(Player player) {
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

    private Approach approach(Player player, Player opponent) {
        return new Approach(
                player, opponent, player.fouls().velocity(), match.ball().position());
    }

    /** Motion of a robot before a collision. */
    private record Approach(Player player, Player opponent, Vector3 velocity, Vector3 ball) {

        double speed() {
            return velocity.length();
        }

        double ballDistance() {
            return Referee.flatDistance(player, ball);
        }

        double angleToBall() {
            return angle(ball);
        }

        double angleToOpponent() {
            return angle(opponent.position());
        }

        private double angle(Vector3 target) {
            Vector3 direction = flat(target.minus(player.position()));
            double product = direction.length() * velocity.length();
            return product == 0
                    ? 0
                    : PortableMath.toDegrees(
                            PortableMath.acos(Math.max(-1, Math.min(1, direction.dot(velocity) / product))));
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

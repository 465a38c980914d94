package org.robonewbie.simulator.soccer;

import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.simulator.world.RobotPart;
import org.robonewbie.simulator.world.SoccerWorld;

/**
 * Tracks the last touch of the ball and whether it is on the pitch or in a goal (SimSpark: {@code ballstateaspect.cpp}).
 */
final class BallTracker implements Memory {

    private static final double MARGIN = 0.001;
    private static final double MAX_SECONDS_SINCE_CROSSING = 1;

    private final SoccerWorld world;
    private final SoccerField field;
    private Optional<Touch> lastTouch = Optional.empty();
    private Vector3 lastValidPosition = Vector3.ZERO;
    private boolean onField = true;

    BallTracker(SoccerWorld world) {
        this.world = world;
        this.field = world.field();
    }

    /** Touch of the ball by a player. */
    record Touch(Player player, long tick) {}

    void update(long tick, List<Player> players) {
        for (RobotPart part : world.ballTouches()) {
            for (Player player : players) {
                if (player.robot() == part.robot()) {
                    lastTouch = Optional.of(new Touch(player, tick));
                    player.fouls().touchedBall(tick);
                }
            }
        }
        onField = isOnField(position());
        if (onField) {
            lastValidPosition = position();
        }
    }

    void forgetTouches() {
        lastTouch = Optional.empty();
    }

    void replace(Player old, Player replacement) {
        lastTouch = lastTouch
                .filter(touch -> touch.player() == old)
                .map(touch -> new Touch(replacement, touch.tick()))
                .or(() -> lastTouch);
    }

    Vector3 position() {
        return world.ball().position();
    }

    void place(Vector3 position) {
        world.ball().place(position);
    }

    double radius() {
        return world.ball().properties().radius();
    }

    Optional<Touch> lastTouch() {
        return lastTouch;
    }

    /** Returns the player that last touched the ball, if the touch was after a given tick. */
    Optional<Player> touchedAfter(long tick) {
        return lastTouch.filter(touch -> touch.tick() > tick).map(Touch::player);
    }

    Vector3 lastValidPosition() {
        return lastValidPosition;
    }

    boolean isOnField() {
        return onField;
    }

    /** Returns the side of the goal that contains the ball; empty if neither does. */
    Optional<TeamSide> goal() {
        for (TeamSide side : TeamSide.values()) {
            if (world.isBallInGoal(side) || hasCrossedGoalLine(side)) {
                return Optional.of(side);
            }
        }
        return Optional.empty();
    }

    private boolean isOnField(Vector3 position) {
        return Math.abs(position.x()) < field.length() / 2 + radius() + MARGIN
                && Math.abs(position.y()) < field.width() / 2 + radius() + MARGIN;
    }

    /**
     * Returns whether the ball is behind the goal line and crossed it inside the goal, based on its position and
     * velocity. Detects a goal even if the ball is too fast for the contact test.
     */
    private boolean hasCrossedGoalLine(TeamSide side) {
        double sign = side == TeamSide.LEFT ? -1 : 1;
        Vector3 ball = position();
        Vector3 velocity = world.ball().velocity();
        double beyond = sign * ball.x() - field.length() / 2;
        double speed = sign * velocity.x();
        if (beyond < radius() || speed <= 0 || beyond / speed > MAX_SECONDS_SINCE_CROSSING) {
            return false;
        }
        Vector3 crossing = ball.minus(velocity.times(beyond / speed));
        return Math.abs(crossing.y()) < field.goalWidth() / 2 && crossing.z() < field.goalHeight();
    }

    @Override
    public void save(StateWriter out, Roster roster) {
        out.putOptional(lastTouch, touch -> {
            roster.save(touch.player(), out);
            out.putLong(touch.tick());
        });
        out.putVector(lastValidPosition);
        out.putBoolean(onField);
    }

    @Override
    public void restore(StateReader in, Roster roster) {
        lastTouch = in.getOptional(() -> new Touch(roster.restore(in), in.getLong()));
        lastValidPosition = in.getVector();
        onField = in.getBoolean();
    }
}

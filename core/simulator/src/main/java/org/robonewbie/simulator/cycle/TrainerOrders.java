package org.robonewbie.simulator.cycle;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.simulator.soccer.Match;
import org.robonewbie.simulator.soccer.Player;
import org.robonewbie.simulator.world.Ball;
import org.robonewbie.simulator.world.Robot;

/**
 * Executes trainer commands between two cycles. Commands for a missing robot have no effect, as in rcssserver3d (SimSpark: {@code
 * trainercommandparser.cpp}).
 */
public final class TrainerOrders {

    private final SimulationCycle cycle;
    private final Match match;
    private final Runnable fullState;
    private final Runnable end;
    private Optional<PlayerNumber> selection = Optional.empty();

    /**
     * Creates the executor.
     *
     * @param cycle the simulation to change
     * @param fullState requests a full message for all monitors
     * @param end ends the simulation
     */
    public TrainerOrders(SimulationCycle cycle, Runnable fullState, Runnable end) {
        this.cycle = cycle;
        this.match = cycle.match();
        this.fullState = fullState;
        this.end = end;
    }

    /** {@return the selected player} */
    public Optional<Player> selected() {
        return selection.flatMap(this::player);
    }

    /**
     * Executes a command.
     *
     * @param order the command; clock commands are ignored
     */
    public void execute(Order order) {
        if (order instanceof Order.EndSimulation) {
            end.run();
        } else if (order instanceof Order.Reset) {
            cycle.reset();
        } else if (order instanceof Order.RequestFullState) {
            fullState.run();
        } else if (order instanceof Order.MoveBall move) {
            move(cycle.world().ball(), move);
        } else if (order instanceof Order.SetProperties set) {
            cycle.world().setGrip(set.friction());
            cycle.world().robots().forEach(robot -> robot.setMassFactor(set.mass()));
        } else {
            judge(order);
            select(order);
            move(order);
        }
    }

    private static void move(Ball ball, Order.MoveBall move) {
        move.position().ifPresent(ball::moveTo);
        move.velocity().ifPresent(ball::setVelocity);
    }

    private void judge(Order order) {
        if (order instanceof Order.KickOff kickOff) {
            kickOff.side().ifPresentOrElse(match::kickOff, match::kickOff);
        } else if (order instanceof Order.ChangePlayMode change) {
            match.setPlayMode(change.playMode());
        } else if (order instanceof Order.DropBall) {
            match.dropBall();
        } else if (order instanceof Order.SetTime time) {
            match.state().setPlaySeconds(time.seconds());
        } else if (order instanceof Order.SetScore score) {
            match.state().setScore(score.left(), score.right());
        }
    }

    private void select(Order order) {
        if (order instanceof Order.SelectRobot select) {
            selection = Optional.of(select.player());
        } else if (order instanceof Order.SelectNextRobot) {
            selection = next();
        } else if (order instanceof Order.SelectNoRobot) {
            selection = Optional.empty();
        }
    }

    private void move(Order order) {
        if (order instanceof Order.MoveRobot move) {
            player(move.player()).ifPresent(player -> player.robot().moveTo(move.position()));
        } else if (order instanceof Order.MoveAndTurnRobot move) {
            player(move.player()).ifPresent(player -> player.robot().moveUpright(move.position(), move.degreesFromY()));
        } else if (order instanceof Order.PlaceRobot place) {
            player(place.player()).ifPresent(player -> place(player.robot(), place));
        } else if (order instanceof Order.PushRobot push) {
            player(push.player()).ifPresent(player -> player.robot().push(push.newtons()));
        } else if (order instanceof Order.RepelSelectedRobot) {
            selected().ifPresent(match::moveTowardsOwnGoal);
        } else if (order instanceof Order.KillRobot kill) {
            forPlayer(kill.player(), cycle::removeRobot);
        } else if (order instanceof Order.RepositionRobot reposition) {
            forPlayer(reposition.player(), match::putBesidePitch);
        }
    }

    private static void place(Robot robot, Order.PlaceRobot place) {
        robot.moveUpright(place.position(), place.headingDegrees() - 90);
        robot.wake();
    }

    private void forPlayer(Optional<PlayerNumber> named, Consumer<Player> action) {
        named.or(() -> selection).flatMap(this::player).ifPresent(action);
    }

    private Optional<Player> player(PlayerNumber number) {
        return match.teams().player(number.side(), number.number());
    }

    private Optional<PlayerNumber> next() {
        List<Player> players = match.teams().players();
        int index = 1 + selected().map(players::indexOf).orElse(-1);
        return players.isEmpty()
                ? Optional.empty()
                : Optional.of(players.get(index % players.size()))
                        .map(player -> new PlayerNumber(player.side(), player.number()));
    }
}

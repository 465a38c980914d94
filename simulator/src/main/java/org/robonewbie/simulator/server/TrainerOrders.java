package org.robonewbie.simulator.server;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.robonewbie.protocol.monitor.PlayerNumber;
import org.robonewbie.protocol.monitor.TrainerCommand;
import org.robonewbie.simulator.soccer.Match;
import org.robonewbie.simulator.soccer.Player;
import org.robonewbie.simulator.soccer.TrainersHand;
import org.robonewbie.simulator.world.Ball;

/**
 * Carries out what trainers order, between two cycles. Orders that mean nobody do nothing, as in the original (SimSpark: {@code
 * trainercommandparser.cpp}).
 */
final class TrainerOrders {

    private final SimulationCycle cycle;
    private final Match match;
    private final TrainersHand hand;
    private final Runnable fullState;
    private final Runnable end;
    private Optional<PlayerNumber> selection = Optional.empty();

    /**
     * Prepares for orders.
     *
     * @param cycle what is changed
     * @param fullState lets monitors have the whole scene
     * @param end ends the simulation
     */
    TrainerOrders(SimulationCycle cycle, Runnable fullState, Runnable end) {
        this.cycle = cycle;
        this.match = cycle.match();
        this.hand = new TrainersHand(match);
        this.fullState = fullState;
        this.end = end;
    }

    /** Tells which player is selected. */
    Optional<Player> selected() {
        return selection.flatMap(this::player);
    }

    void carryOut(TrainerCommand command) {
        if (command instanceof TrainerCommand.EndSimulation) {
            end.run();
        } else if (command instanceof TrainerCommand.RequestFullState) {
            fullState.run();
        } else if (command instanceof TrainerCommand.MoveBall move) {
            move(cycle.world().ball(), move);
        } else {
            judge(command);
            select(command);
            move(command);
        }
    }

    private static void move(Ball ball, TrainerCommand.MoveBall move) {
        move.position().ifPresent(ball::moveTo);
        move.velocity().ifPresent(ball::setVelocity);
    }

    private void judge(TrainerCommand command) {
        if (command instanceof TrainerCommand.KickOff kickOff) {
            kickOff.side().ifPresentOrElse(match::kickOff, match::kickOff);
        } else if (command instanceof TrainerCommand.ChangePlayMode change) {
            match.setPlayMode(change.playMode());
        } else if (command instanceof TrainerCommand.DropBall) {
            match.dropBall();
        } else if (command instanceof TrainerCommand.SetTime time) {
            hand.setPlaySeconds(time.seconds());
        } else if (command instanceof TrainerCommand.SetScore score) {
            hand.setScore(score.left(), score.right());
        }
    }

    private void select(TrainerCommand command) {
        if (command instanceof TrainerCommand.SelectRobot select) {
            selection = Optional.of(select.player());
        } else if (command instanceof TrainerCommand.SelectNextRobot) {
            selection = next();
        } else if (command instanceof TrainerCommand.SelectNoRobot) {
            selection = Optional.empty();
        }
    }

    private void move(TrainerCommand command) {
        if (command instanceof TrainerCommand.MoveRobot move) {
            player(move.player()).ifPresent(player -> player.robot().moveTo(move.position()));
        } else if (command instanceof TrainerCommand.MoveAndTurnRobot move) {
            player(move.player()).ifPresent(player -> player.robot().moveUpright(move.position(), move.degreesFromY()));
        } else if (command instanceof TrainerCommand.RepelSelectedRobot) {
            selected().ifPresent(hand::moveTowardsOwnGoal);
        } else if (command instanceof TrainerCommand.KillRobot kill) {
            forPlayer(kill.player(), cycle::removeRobot);
        } else if (command instanceof TrainerCommand.RepositionRobot reposition) {
            forPlayer(reposition.player(), hand::putBesidePitch);
        }
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

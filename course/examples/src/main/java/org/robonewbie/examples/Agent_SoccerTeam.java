package org.robonewbie.examples;

import java.util.stream.IntStream;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.Options;
import org.robonewbie.agent.perception.FieldItem;
import org.robonewbie.agent.perception.HeardMessage;

/**
 * A team with roles: number 1 keeps goal, the other player nearest to the ball attacks as {@link Agent_SimpleSoccer}
 * does, and the others keep the ball in view. The players broadcast their distances to the ball to find out which of
 * them is nearest.
 *
 * <p>{@code Agent_SoccerTeam 3 --team Blue} starts three players with one command. Run it again with a different team name
 * to add opponents.
 */
public final class Agent_SoccerTeam extends Agent_SimpleSoccer {

    private static final String DEFAULT_PLAYERS = "3";
    private static final double KEEPER_LEAVES_GOAL_METRES = 2;
    private static final double FACING_DEGREES = 15;
    private static final double MEMORY_SECONDS = 2;

    private final int number;
    private double mateDistance = Double.POSITIVE_INFINITY;
    private double mateHeardSeconds;

    /**
     * Creates a player.
     *
     * @param number player number, 1 to 11
     */
    public Agent_SoccerTeam(int number) {
        this.number = number;
    }

    /**
     * Starts the players.
     *
     * @param args number of players, 1 to 11, and options such as {@code --team Blue}
     */
    public static void main(String[] args) {
        Agent[] team = IntStream.rangeClosed(1, players(args))
                .mapToObj(Agent_SoccerTeam::new)
                .toArray(Agent[]::new);
        runTogether(args, team);
    }

    private static int players(String[] args) {
        String players = args.length > 0 && !args[0].startsWith("-") ? args[0] : DEFAULT_PLAYERS;
        if (!players.matches("[1-9]|1[01]")) {
            System.err.println("A team has 1 to 11 players, not \"" + players + "\".");
            System.exit(2);
        }
        return Integer.parseInt(players);
    }

    @Override
    protected Options defaults() {
        return Options.none().withWords().withNumber(number);
    }

    @Override
    protected void think() {
        listen();
        FieldItem ball = fieldView.ball();
        if (ball.ageSeconds() < MEMORY_SECONDS) {
            nao.say("ball-" + Math.round(ball.distance() * 100));
        }
        super.think();
    }

    @Override
    protected void decide() {
        boolean attacks = number == 1
                ? fieldView.ball().distance() < KEEPER_LEAVES_GOAL_METRES
                : fieldView.ball().distance() <= distanceOfNearestMate();
        if (attacks || nao.isFallen()) {
            super.decide();
        } else {
            faceBall();
        }
    }

    private void faceBall() {
        FieldItem ball = fieldView.ball();
        if (ball.ageSeconds() > MEMORY_SECONDS) {
            motions.start("turn-left");
        } else if (Math.abs(ball.bearing()) > FACING_DEGREES) {
            motions.start(ball.bearing() > 0 ? "turn-left-small" : "turn-right-small");
        } else {
            motions.start("stand");
        }
    }

    private double distanceOfNearestMate() {
        return nao.getTime() - mateHeardSeconds < MEMORY_SECONDS ? mateDistance : Double.POSITIVE_INFINITY;
    }

    private void listen() {
        for (HeardMessage heard : nao.getHeard()) {
            boolean fromMate = heard.team().filter(nao.getTeam()::equals).isPresent();
            if (fromMate && heard.text().matches("ball-\\d{1,5}")) {
                mateDistance = Integer.parseInt(heard.text().substring(5)) / 100.0;
                mateHeardSeconds = nao.getTime();
            }
        }
    }
}

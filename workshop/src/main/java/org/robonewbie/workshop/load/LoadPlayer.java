package org.robonewbie.workshop.load;

import java.io.IOException;
import java.util.List;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.protocol.effector.EffectorMessageWriter;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.GameState;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PerceptorMessageReader;
import org.robonewbie.simulator.server.SyntheticPlayer;

/**
 * Player for load tests that bends its knees and swings its arms without falling, so that its cost is constant. It
 * parses every message.
 */
final class LoadPlayer extends SyntheticPlayer {

    private static final double SPACING_METRES = 4;
    private static final double BEND_RADIANS = Math.toRadians(10);
    private static final double RADIANS_PER_SECOND = 2 * Math.PI / 1.6;

    private final boolean isTimed;
    private final Arrivals arrivals = new Arrivals();
    private final PerceptorMessageReader reader = new PerceptorMessageReader();
    private volatile String playMode = "";
    private volatile double playSeconds;
    private volatile int endedMatches;

    /** Connects a player. A timed player keeps the arrival times of its messages in memory. */
    LoadPlayer(int port, int index, boolean isTimed) throws IOException {
        super(port, index, SPACING_METRES);
        this.isTimed = isTimed;
    }

    Arrivals arrivals() {
        return arrivals;
    }

    /** Returns whether the player has received a play mode. */
    boolean isInTheGame() {
        return !playMode.isEmpty();
    }

    /** Returns whether a match is in progress. */
    boolean isPlaying() {
        return isInTheGame() && !playMode.equals(PlayMode.GAME_OVER.simSparkName());
    }

    int endedMatches() {
        return endedMatches;
    }

    double playSeconds() {
        return playSeconds;
    }

    @Override
    protected void received(MessageBuffer perceptors) {
        PerceptorMessage message = reader.read(perceptors);
        if (isTimed) {
            arrivals.add(System.nanoTime(), message.seconds().orElse(0));
        }
        message.gameState().ifPresent(this::watch);
    }

    /** Called only by the player's thread; no other thread writes the volatile fields. */
    @SuppressWarnings("NonAtomicVolatileUpdate")
    private void watch(GameState state) {
        boolean over = state.playModeName().equals(PlayMode.GAME_OVER.simSparkName());
        playSeconds = state.playSeconds();
        if (over && !playMode.equals(state.playModeName())) {
            endedMatches++;
        }
        playMode = state.playModeName();
    }

    @Override
    protected boolean isBeforeKickOff(double seconds) {
        return playMode.equals(PlayMode.BEFORE_KICK_OFF.simSparkName());
    }

    @Override
    protected void move(EffectorMessageWriter commands, double seconds) {
        double bend = BEND_RADIANS / 2 * RADIANS_PER_SECOND * Math.sin(RADIANS_PER_SECOND * seconds);
        for (String side : List.of("l", "r")) {
            commands.hingeSpeed(side + "le3", bend)
                    .hingeSpeed(side + "le4", -2 * bend)
                    .hingeSpeed(side + "le5", bend);
            commands.hingeSpeed(side + "ae1", -bend);
        }
    }
}

package org.robonewbie.studio.monitor;

import java.util.function.LongSupplier;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.protocol.monitor.MonitoredGame;
import org.robonewbie.protocol.monitor.MonitoredWorld;

/**
 * Estimates the cycle number of a server that sends only the game time. The game time does not advance before a
 * kick-off or after the game; each message then counts as two cycles, the usual interval between messages.
 */
final class MonitorClock {

    private static final int DEFAULT_CYCLES_PER_MESSAGE = 2;
    private static final int MESSAGES_UNTIL_STANDSTILL = 10;
    private static final double FOLLOWING = 0.1;
    private static final double MAX_GAP_SECONDS = 10;

    private final LongSupplier nanoTime;
    private double lastPlaySeconds = Double.NaN;
    private double lastServerSeconds = Double.NaN;
    private long cycle;
    private int messagesWithoutTime;
    private long lastNanos;
    private double realTimeFactor = 1;

    MonitorClock() {
        this(System::nanoTime);
    }

    MonitorClock(LongSupplier nanoTime) {
        this.nanoTime = nanoTime;
        this.lastNanos = nanoTime.getAsLong();
    }

    /** Advances to the latest message. RCSSServerMJ sends its time, so that nothing needs to be estimated. */
    void tick(MonitoredWorld world) {
        if (world.rsmp().isPresent()) {
            tickTo(world.rsmp().get().seconds());
        } else {
            tick(world.gameState());
        }
    }

    private void tickTo(double seconds) {
        double passed = seconds - lastServerSeconds;
        lastServerSeconds = seconds;
        boolean isNext = passed > 0 && passed < MAX_GAP_SECONDS;
        long cycles = isNext ? Math.max(1, Math.round(passed / Cycle.SECONDS)) : DEFAULT_CYCLES_PER_MESSAGE;
        follow(cycles);
        cycle += cycles;
    }

    private void tick(MonitoredGame game) {
        double seconds = game.timeSeconds() - lastPlaySeconds;
        boolean moves = seconds > 0 && seconds < MAX_GAP_SECONDS;
        boolean mayStand = game.playMode()
                .filter(mode -> mode == PlayMode.BEFORE_KICK_OFF || mode == PlayMode.GAME_OVER)
                .isPresent();
        lastPlaySeconds = game.timeSeconds();
        messagesWithoutTime = moves || mayStand ? 0 : messagesWithoutTime + 1;
        if (moves) {
            long cycles = Math.max(1, Math.round(seconds / Cycle.SECONDS));
            follow(cycles);
            cycle += cycles;
        } else if (mayStand) {
            follow(DEFAULT_CYCLES_PER_MESSAGE);
            cycle += DEFAULT_CYCLES_PER_MESSAGE;
        }
    }

    private void follow(long cycles) {
        long now = nanoTime.getAsLong();
        double real = Math.max(1e-4, (now - lastNanos) / 1e9);
        lastNanos = now;
        realTimeFactor += FOLLOWING * (Math.min(100, cycles * Cycle.SECONDS / real) - realTimeFactor);
    }

    long cycle() {
        return cycle;
    }

    /** Returns the estimated real-time factor: simulated seconds per second of real time. */
    double realTimeFactor() {
        return realTimeFactor;
    }

    /** Returns whether messages arrive while the game time stands still unexpectedly, as when the server is paused. */
    boolean isStandingStill() {
        return messagesWithoutTime > MESSAGES_UNTIL_STANDSTILL;
    }
}

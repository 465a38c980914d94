package org.robonewbie.agent.running;

import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/**
 * One robot's turn to join a server; the next robot of the same program waits until the turn is over. rcssserver3d puts
 * robots that join simultaneously at the same position, and the contacts between eleven overlapping robots keep it busy
 * for minutes.
 */
public final class JoinTurn {

    private static final Duration SILENCE = Duration.ofSeconds(1);
    private static final Duration LEAGUE_SILENCE = Duration.ofSeconds(60);

    private final Duration silence;
    private final CountDownLatch answered = new CountDownLatch(1);
    private final CountDownLatch ended = new CountDownLatch(1);

    /** Starts a turn. */
    public JoinTurn() {
        this(SILENCE);
    }

    JoinTurn(Duration silence) {
        this.silence = silence;
    }

    /**
     * Starts a turn on RCSSServerMJ, which needs up to several seconds for each robot that joins.
     *
     * @return the turn
     */
    public static JoinTurn ofLeague() {
        return new JoinTurn(LEAGUE_SILENCE);
    }

    /** Records that the server has responded to the robot. */
    public void answered() {
        answered.countDown();
    }

    /** Ends the turn: the robot has reached its starting pose, or has failed to join. */
    public void end() {
        answered();
        ended.countDown();
    }

    /**
     * Waits until the turn is over, or gives up if the server does not respond within a second.
     *
     * @return whether the server has responded; if not, it is waiting for more robots to join before it starts its
     *     clock
     */
    public boolean await() {
        try {
            boolean answers = answered.await(silence.toMillis(), TimeUnit.MILLISECONDS);
            if (answers) {
                ended.await();
            }
            return answers;
        } catch (InterruptedException end) {
            Thread.currentThread().interrupt();
            return false;
        }
    }
}

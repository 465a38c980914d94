package org.robonewbie.agent.running;

import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/**
 * The turn of one robot to join a server; the next robot of the same program waits for its end. rcssserver3d puts robots that
 * join simultaneously into the same place, and the contacts of eleven of them keep it busy for minutes.
 */
public final class JoinTurn {

    private static final Duration SILENCE = Duration.ofSeconds(1);

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

    /** Marks that the server has answered the robot. */
    public void answered() {
        answered.countDown();
    }

    /** Ends the turn: the robot is at its place, or will never be there. */
    public void end() {
        answered();
        ended.countDown();
    }

    /**
     * Waits until the turn is over, or for a second until the server answers.
     *
     * @return whether the server answers; one that does not is holding its first cycle until more robots have joined
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

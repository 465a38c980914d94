package org.robonewbie.agent.running;

import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/**
 * The turn of one robot to join a server, which the next robot of the same program awaits. rcssserver3d puts all robots that join in the
 * same moment into the same place, and the contacts of eleven of them keep it busy for minutes.
 */
public final class JoinTurn {

    private static final Duration SILENCE = Duration.ofSeconds(1);

    private final Duration silence;
    private final CountDownLatch answered = new CountDownLatch(1);
    private final CountDownLatch ended = new CountDownLatch(1);

    /** Begins a turn. */
    public JoinTurn() {
        this(SILENCE);
    }

    JoinTurn(Duration silence) {
        this.silence = silence;
    }

    /** Notes that the server has answered the robot. */
    public void answered() {
        answered.countDown();
    }

    /** Ends the turn: the robot is at its place, or will never be there. */
    public void end() {
        answered();
        ended.countDown();
    }

    /**
     * Waits until the turn is over, or until the server has not answered for a second.
     *
     * @return whether the server answers; one that does not holds its first cycle until more robots have come
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

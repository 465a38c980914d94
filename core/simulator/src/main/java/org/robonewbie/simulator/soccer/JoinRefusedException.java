package org.robonewbie.simulator.soccer;

/** A robot may not join the team it asked for. */
public final class JoinRefusedException extends Exception {

    JoinRefusedException(String reason) {
        super(reason);
    }
}

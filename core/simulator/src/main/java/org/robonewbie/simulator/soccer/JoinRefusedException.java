package org.robonewbie.simulator.soccer;

/** Thrown when a robot may not join a team. */
public final class JoinRefusedException extends Exception {

    JoinRefusedException(String reason) {
        super(reason);
    }
}

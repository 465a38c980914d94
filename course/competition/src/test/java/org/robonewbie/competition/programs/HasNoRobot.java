package org.robonewbie.competition.programs;

import java.util.concurrent.CompletableFuture;

/** Never asks for a robot. */
public final class HasNoRobot {

    private HasNoRobot() {}

    /**
     * Does something else.
     *
     * @param args are not looked at
     */
    public static void main(String[] args) {
        new CompletableFuture<Void>().join();
    }
}

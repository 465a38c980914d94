package org.robonewbie.competition.programs;

import java.util.concurrent.CompletableFuture;
import org.robonewbie.agent.Nao;

/** Gets its robot and gives no answer any more, without calculating anything. */
public final class FallsAsleep {

    private FallsAsleep() {}

    /**
     * Starts the robot.
     *
     * @param args its options
     */
    public static void main(String[] args) {
        try (Nao nao = Nao.connect(args)) {
            nao.sense();
            new CompletableFuture<Void>().join();
        }
    }
}

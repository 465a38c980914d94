package org.robonewbie.competition.programs;

import java.util.concurrent.CompletableFuture;
import org.robonewbie.agent.Nao;

/** Leaves the pitch, while its process goes on. */
public final class Leaves {

    private Leaves() {}

    /**
     * Starts the robot.
     *
     * @param args its options
     */
    public static void main(String[] args) {
        try (Nao nao = Nao.connect(args)) {
            nao.sense();
        }
        new CompletableFuture<Void>().join();
    }
}

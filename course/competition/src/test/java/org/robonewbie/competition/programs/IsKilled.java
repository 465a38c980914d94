package org.robonewbie.competition.programs;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.concurrent.CompletableFuture;

/** Its Java dies all of a sudden, as by a fault of a native library. */
public final class IsKilled extends Misbehaving {

    /**
     * Starts the robot.
     *
     * @param args its options
     */
    public static void main(String[] args) {
        new IsKilled().run(args);
    }

    @Override
    protected void misbehave() {
        try {
            new ProcessBuilder(
                            "kill", "-9", Long.toString(ProcessHandle.current().pid()))
                    .start();
        } catch (IOException noSuchCommand) {
            throw new UncheckedIOException(noSuchCommand);
        }
        new CompletableFuture<Void>().join(); // it dies in this cycle
    }
}

package org.robonewbie.workshop.fidelity;

import java.util.List;

/**
 * Initial condition of a recorded ball.
 *
 * @param name name that encodes the condition, such as {@code roll_v3}, {@code drop_h0.5} or {@code lob_4_4}; the
 *     numbers are the speeds along x and upward in m/s, or the height in m
 * @param cycles number of cycles of 20 ms to record
 */
public record BallCase(String name, int cycles) {

    /** Slow and fast rolls, drops and lobs. */
    public static final List<BallCase> ALL = List.of(
            new BallCase("roll_v1", 400),
            new BallCase("roll_v3", 500),
            new BallCase("roll_v8", 500),
            new BallCase("drop_h1", 300),
            new BallCase("lob_4_4", 500),
            new BallCase("lob_6_3", 500));
}

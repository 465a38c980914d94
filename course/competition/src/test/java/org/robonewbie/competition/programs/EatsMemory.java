package org.robonewbie.competition.programs;

import java.util.ArrayList;
import java.util.List;

/** Takes all the memory that there is. */
public final class EatsMemory extends Misbehaving {

    private final List<byte[]> food = new ArrayList<>();

    /**
     * Starts the robot.
     *
     * @param args its options
     */
    public static void main(String[] args) {
        new EatsMemory().run(args);
    }

    @Override
    protected void misbehave() {
        food.add(new byte[50_000_000]);
    }
}

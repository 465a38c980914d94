package org.robonewbie.competition.programs;

/** Never comes back from thinking. */
public final class Hangs extends Misbehaving {

    private long count;

    /**
     * Starts the robot.
     *
     * @param args its options
     */
    public static void main(String[] args) {
        new Hangs().run(args);
    }

    @Override
    protected void misbehave() {
        while (count >= 0) {
            count = (count + 1) % 1000;
        }
    }
}

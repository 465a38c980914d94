package org.robonewbie.competition.programs;

/** Ends its own process. */
public final class CallsExit extends Misbehaving {

    /**
     * Starts the robot.
     *
     * @param args its options
     */
    public static void main(String[] args) {
        new CallsExit().run(args);
    }

    @Override
    protected void misbehave() {
        System.exit(0);
    }
}

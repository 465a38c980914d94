package student;

import org.robonewbie.agent.Agent;

/** Wants to play a motion that does not exist. */
public final class MissingMotion extends Agent {

    private boolean begun;

    /** Creates the agent. */
    public MissingMotion() {}

    /**
     * Starts the robot.
     *
     * @param args options
     */
    public static void main(String[] args) {
        new MissingMotion().run(args);
    }

    @Override
    protected void think() {
        if (!begun) {
            begun = true;
            motions.start("wawe");
        }
    }
}

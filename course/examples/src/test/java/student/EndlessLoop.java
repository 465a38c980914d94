package student;

import org.robonewbie.agent.Agent;

/** Waits in think() for something that cannot happen while it waits. */
public final class EndlessLoop extends Agent {

    /** Creates the agent. */
    public EndlessLoop() {}

    /**
     * Starts the robot.
     *
     * @param args options
     */
    public static void main(String[] args) {
        new EndlessLoop().run(args);
    }

    @Override
    protected void think() {
        log.info("I think");
        int rounds = 0;
        while (fieldView.ball().ageSeconds() > 0) {
            rounds++;
        }
        log.info("%d rounds", rounds);
    }
}

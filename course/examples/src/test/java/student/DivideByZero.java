package student;

import org.robonewbie.agent.Agent;

/** Fails in each think(). */
public final class DivideByZero extends Agent {

    /** Creates the agent. */
    public DivideByZero() {}

    /**
     * Starts the robot.
     *
     * @param args options
     */
    public static void main(String[] args) {
        new DivideByZero().run(args);
    }

    @Override
    protected void think() {
        log.info("cycle at %.2f", nao.getTime());
        log.info("%d", 1 / nao.getOwnScore());
    }
}

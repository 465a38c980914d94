package student;

import org.robonewbie.agent.Agent;

/** Does nothing but write a log. */
public final class Patient extends Agent {

    private boolean greeted;

    /** Creates the agent. */
    public Patient() {}

    /**
     * Starts the robot.
     *
     * @param args options
     */
    public static void main(String[] args) {
        new Patient().run(args);
    }

    @Override
    protected void think() {
        log.info("I am here");
        if (!greeted) {
            System.out.println("thinking");
            greeted = true;
        }
    }
}

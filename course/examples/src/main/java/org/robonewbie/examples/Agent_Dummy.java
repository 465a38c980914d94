package org.robonewbie.examples;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.Options;

/**
 * A partner for {@link Agent_TestPerceptorInput} and {@link Agent_TestLocalFieldView}: it stands on the field and says
 * hello from time to time.
 */
public final class Agent_Dummy extends Agent {

    private int cycle;

    /** Creates the agent. */
    public Agent_Dummy() {}

    /**
     * Starts the robot.
     *
     * @param args options such as {@code --number 2}; {@code --help} lists them
     */
    public static void main(String[] args) {
        new Agent_Dummy().run(args);
    }

    @Override
    protected Options defaults() {
        return Options.none().withTeam("teamB").withPose(-1, 0, 0);
    }

    @Override
    protected void think() {
        if (cycle++ % 4 == 0) {
            nao.say("greetings-from-" + nao.getNumber());
        }
    }
}

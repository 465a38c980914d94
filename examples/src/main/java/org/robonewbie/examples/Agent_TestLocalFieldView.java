package org.robonewbie.examples;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.Options;
import org.robonewbie.agent.perception.LineItem;
import org.robonewbie.agent.perception.PlayerItem;
import org.robonewbie.nao.BodyPart;
import org.robonewbie.nao.Landmark;

/**
 * Shows what the robot remembers of the field while its head looks around, twice per second for five seconds.
 *
 * <p>Watch how things stay known when the head turns away, and how their age grows. Start {@link Agent_Dummy} in the same
 * simulator to see another robot.
 */
public final class Agent_TestLocalFieldView extends Agent {

    private int cycle;

    /** Creates the agent. */
    public Agent_TestLocalFieldView() {}

    /**
     * Starts the robot.
     *
     * @param args options such as {@code --headless}; {@code --help} lists them
     */
    public static void main(String[] args) {
        new Agent_TestLocalFieldView().run(args);
    }

    @Override
    protected Options defaults() {
        return Options.none().withTeam("teamA").withPose(-1, 0.7, -60).withSeconds(5);
    }

    @Override
    protected void think() {
        lookAround.look();
        if (cycle++ % 25 == 0) {
            logView();
        }
    }

    private void logView() {
        log.info("%s%s", fieldView.ball(), fieldView.ball().isVisible() ? ", visible now" : "");
        for (Landmark landmark : Landmark.values()) {
            log.info("%s", fieldView.landmark(landmark));
        }
        for (PlayerItem player : fieldView.players()) {
            log.info("%s; %s", player, player.part(BodyPart.HEAD));
        }
        for (LineItem line : fieldView.lines()) {
            log.info("line from %s to %s", line.start(), line.end());
        }
    }
}

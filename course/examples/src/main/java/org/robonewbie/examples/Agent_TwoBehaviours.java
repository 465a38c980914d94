package org.robonewbie.examples;

import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.Options;
import org.robonewbie.nao.Joint;

/**
 * Two concurrent behaviours in separate threads: the head follows the ball while the left arm swings. Both run once in each
 * cycle, and {@code think} waits for both, so that all commands are sent in the same message.
 *
 * <p>The behaviours move different joints. What happens if both move the same one?
 */
public final class Agent_TwoBehaviours extends Agent {

    private final ExecutorService threads = Executors.newFixedThreadPool(2, work -> {
        Thread thread = new Thread(work, "behaviour");
        thread.setDaemon(true); // does not keep the program alive
        return thread;
    });
    private final List<Callable<Object>> behaviours =
            List.of(Executors.callable(this::followBall), Executors.callable(this::swingArm));

    /** Creates the agent. */
    public Agent_TwoBehaviours() {}

    /**
     * Starts the robot.
     *
     * @param args options such as {@code --headless}; {@code --help} lists them
     */
    public static void main(String[] args) {
        new Agent_TwoBehaviours().run(args);
    }

    @Override
    protected Options defaults() {
        return Options.none().withPose(-1, 0.5, -30);
    }

    @Override
    protected void think() {
        try {
            threads.invokeAll(behaviours);
        } catch (InterruptedException end) {
            Thread.currentThread().interrupt();
        }
    }

    private void followBall() {
        if (fieldView.ball().ageSeconds() < 1) {
            nao.setJointAngle(
                    Joint.NECK_YAW,
                    Math.max(-100, Math.min(100, fieldView.ball().bearing())),
                    120);
        } else {
            lookAround.look();
        }
    }

    private void swingArm() {
        nao.setJointAngle(Joint.LEFT_SHOULDER_PITCH, 45 * Math.sin(2 * Math.PI * nao.getTime() / 2));
    }
}

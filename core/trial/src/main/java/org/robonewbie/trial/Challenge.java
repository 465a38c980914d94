package org.robonewbie.trial;

import java.util.Map;
import java.util.function.Supplier;
import org.robonewbie.simulator.recording.RecordingTarget;

/**
 * A task for a program: the scene, the events in it, and the measure. Exercises are challenges, and any challenge can be a contest.
 * Each trial needs a new instance, since a challenge accumulates its observations.
 *
 * <pre>{@code
 * Challenge challenge = new KickTask();
 * challenge.play(12, seed, RobotStart.TEAM, () -> Controller.ofAgent(new MyKick()), TrialListener.NONE, RecordingTarget.NONE);
 * double points = challenge.value();
 * }</pre>
 */
public interface Challenge extends Measure, TrialHook {

    /**
     * Creates the scene. The program under test moves the robots of the team {@link RobotStart#TEAM}; all others hold still.
     *
     * @param random source of everything that depends on the seed
     * @return the scene
     */
    Scene scene(RandomSource random);

    /**
     * Completes the scene after the robots have taken their initial postures.
     *
     * @param trial the trial at its start
     */
    default void begin(Trial trial) {}

    @Override
    default void act(Trial trial) {}

    /** {@return all results by name} */
    default Map<String, Double> figures() {
        return Map.of("value", value());
    }

    /**
     * Runs the trial to its end on the current thread.
     *
     * @param seconds maximum simulated duration of the trial
     * @param seed seed of the trial
     * @param team name of the team under test
     * @param contender creates the controller of each robot under test when it enters
     * @param listener called after each cycle
     * @param recording receives a recording of the trial
     * @return simulated duration in seconds
     */
    default double play(
            double seconds,
            long seed,
            String team,
            Supplier<? extends Controller> contender,
            TrialListener listener,
            RecordingTarget recording) {
        try (ChallengeTrial played = new ChallengeTrial(this, seconds, seed, team, contender, listener, recording)) {
            while (!played.isOver()) {
                played.step();
            }
            return played.trial().seconds();
        }
    }
}

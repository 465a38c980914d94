package org.robonewbie.trial;

import java.util.Map;
import java.util.function.Supplier;
import org.robonewbie.simulator.recording.RecordingTarget;

/**
 * A task for a program: the scene, the events in it, and the measure. Every exercise is a challenge, and any challenge can be
 * used as a contest. Each trial needs a new instance, because a challenge accumulates its observations.
 *
 * <pre>{@code
 * Challenge challenge = new KickTask();
 * challenge.play(12, seed, RobotStart.TEAM, () -> Controller.ofAgent(new MyKick()), TrialListener.NONE, RecordingTarget.NONE);
 * double points = challenge.value();
 * }</pre>
 */
public interface Challenge extends Measure, TrialHook {

    /**
     * Creates the scene. The program under test controls the robots of the team {@link RobotStart#TEAM}; all other robots
     * hold still.
     *
     * @param random source of all random numbers for the scene
     * @return the scene
     */
    Scene scene(RandomSource random);

    /**
     * Completes the scene once the robots have reached their initial postures. Does nothing by default.
     *
     * @param trial the trial at its start
     */
    default void begin(Trial trial) {}

    @Override
    default void act(Trial trial) {}

    /** {@return all measured values by name} */
    default Map<String, Double> figures() {
        return Map.of("value", value());
    }

    /**
     * Runs the trial to its end on the current thread.
     *
     * @param seconds maximum simulated duration of the trial
     * @param seed seed of the trial
     * @param team name of the team under test
     * @param contender creates the controller of each robot under test when that robot enters the pitch
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

package org.robonewbie.trial;

import java.util.Map;
import java.util.function.Supplier;
import org.robonewbie.simulator.recording.RecordingTarget;

/**
 * What a program is challenged to do in one trial: the scene, what happens in it, and what it is measured by. Exercises are
 * challenges, and any challenge can be a contest. Each trial needs a new one, since it keeps what it has seen.
 *
 * <pre>{@code
 * Challenge challenge = new KickTask();
 * challenge.play(12, seed, RobotStart.TEAM, () -> Controller.ofAgent(new MyKick()), TrialListener.NONE, RecordingTarget.NONE);
 * double points = challenge.value();
 * }</pre>
 */
public interface Challenge extends Measure, TrialHook {

    /**
     * Sets the scene. Robots of the team {@link RobotStart#TEAM} are moved by the program that is challenged, others hold still.
     *
     * @param random what differs from seed to seed
     * @return the scene
     */
    Scene scene(RandomSource random);

    /**
     * Completes the scene when the robots have taken their first postures.
     *
     * @param trial the trial at its beginning
     */
    default void begin(Trial trial) {}

    @Override
    default void act(Trial trial) {}

    /** {@return all results by name, for tables} */
    default Map<String, Double> figures() {
        return Map.of("value", value());
    }

    /**
     * Plays the trial to its end in this thread.
     *
     * @param seconds simulated time of the trial
     * @param seed what is left to chance
     * @param team name of those who are challenged
     * @param contender makes the controller of each challenged robot when it enters
     * @param listener sees each cycle
     * @param recording where a recording of the trial goes
     * @return simulated seconds after which it was over
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

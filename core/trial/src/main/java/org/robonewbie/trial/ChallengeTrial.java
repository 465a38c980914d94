package org.robonewbie.trial;

import java.util.Iterator;
import java.util.function.Function;
import java.util.function.Supplier;
import org.robonewbie.simulator.recording.RecordingTarget;

/**
 * One trial of a {@link Challenge} in the hand of somebody who turns it cycle by cycle, such as a page that shows it. It keeps
 * neither thread nor clock.
 *
 * <pre>{@code
 * try (ChallengeTrial trial = new ChallengeTrial(challenge, 12, seed, RobotStart.TEAM, contender, TrialListener.NONE, RecordingTarget.NONE)) {
 *     while (!trial.isOver()) {
 *         trial.step();
 *     }
 * }
 * }</pre>
 */
public final class ChallengeTrial implements AutoCloseable {

    private final Challenge challenge;
    private final double mostSeconds;
    private final Trial trial;

    /**
     * Sets the scene and lets the robots enter.
     *
     * @param challenge what is asked for; used for this trial only
     * @param mostSeconds simulated time of the trial
     * @param seed what is left to chance
     * @param team name of those who are challenged
     * @param contender makes the controller of each challenged robot when it enters
     * @param listener sees each cycle
     * @param recording where a recording of the trial goes
     */
    public ChallengeTrial(
            Challenge challenge,
            double mostSeconds,
            long seed,
            String team,
            Supplier<? extends Controller> contender,
            TrialListener listener,
            RecordingTarget recording) {
        this.challenge = challenge;
        this.mostSeconds = mostSeconds;
        Scene scene = challenge.scene(new RandomSource(seed));
        Iterator<RobotStart> robots = scene.robots().iterator();
        Function<RobotStart, Controller> cast =
                robot -> robots.next().team().equals(RobotStart.TEAM) ? contender.get() : Controller.ofSpeeds();
        trial = Trial.observed(scene.withTeam(team), seed, listener, recording, cast);
        try {
            challenge.begin(trial);
            trial.with(challenge);
            challenge.see(trial.now());
        } catch (RuntimeException | Error failure) {
            trial.close();
            throw failure;
        }
    }

    /** {@return whether the time is over or the challenge is decided} */
    public boolean isOver() {
        return trial.seconds() >= mostSeconds || challenge.isDecided();
    }

    /** Lets all robots and the world go on for one cycle. */
    public void step() {
        challenge.see(trial.step());
    }

    /** {@return the trial that is being played} */
    public Trial trial() {
        return trial;
    }

    @Override
    public void close() {
        trial.close();
    }
}

package org.robonewbie.trial;

import java.util.Iterator;
import java.util.function.Function;
import java.util.function.Supplier;
import org.robonewbie.simulator.recording.RecordingTarget;

/**
 * A trial of a {@link Challenge} that is stepped by its caller, such as a page that displays it. It uses neither
 * threads nor clocks.
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
    private final double maxSeconds;
    private final Trial trial;

    /**
     * Creates the scene and its robots.
     *
     * @param challenge the task; used for this trial only
     * @param maxSeconds maximum simulated duration of the trial
     * @param seed seed of the trial
     * @param team name of the team under test
     * @param contender creates the controller of each robot under test when that robot enters the pitch
     * @param listener called after each cycle
     * @param recording receives a recording of the trial
     */
    public ChallengeTrial(
            Challenge challenge,
            double maxSeconds,
            long seed,
            String team,
            Supplier<? extends Controller> contender,
            TrialListener listener,
            RecordingTarget recording) {
        this.challenge = challenge;
        this.maxSeconds = maxSeconds;
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

    /** {@return whether the time is up or the challenge has been decided} */
    public boolean isOver() {
        return trial.seconds() >= maxSeconds || challenge.isDecided();
    }

    /** Advances all controllers and the world by one cycle. */
    public void step() {
        challenge.see(trial.step());
    }

    /** {@return the running trial} */
    public Trial trial() {
        return trial;
    }

    @Override
    public void close() {
        trial.close();
    }
}

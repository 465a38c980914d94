package org.robonewbie.trial;

/** A callback for external events in a {@link Trial}, such as a shot, a push or a robot being moved. */
@FunctionalInterface
public interface TrialHook {

    /**
     * Called after each cycle, before measures observe the new state.
     *
     * @param trial the trial
     */
    void act(Trial trial);
}

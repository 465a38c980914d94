package org.robonewbie.trial;

/** What happens in a {@link Trial} that no controller does: a shot, a push, a robot that is carried away. */
@FunctionalInterface
public interface TrialHook {

    /**
     * Acts between two cycles, before measures see the result of the first.
     *
     * @param trial the trial
     */
    void act(Trial trial);
}

package org.robonewbie.app.command;

import java.util.Locale;
import org.robonewbie.app.program.CalledWronglyException;
import org.robonewbie.competition.team.Fence;

/** Whether programs of others are to be fenced in. */
enum FenceWish {
    AUTO,
    REQUIRED,
    NONE;

    /**
     * Finds the fence.
     *
     * @throws CalledWronglyException if it is required and there is none
     */
    Fence fence() {
        if (this == NONE) {
            return Fence.none("the organisers did not want it");
        }
        Fence found = Fence.find();
        if (this == REQUIRED && !found.isUp()) {
            throw new CalledWronglyException("Programs cannot be fenced in: " + found.absence()
                    + ". Install the package bubblewrap, or leave --fence required out.");
        }
        return found;
    }

    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }
}

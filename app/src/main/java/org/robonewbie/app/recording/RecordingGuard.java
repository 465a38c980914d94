package org.robonewbie.app.recording;

import java.io.IOException;
import org.robonewbie.learning.dataset.DataSet;

/** Completes the table of runs if the whole process ends in the middle of a recording, as by Control-C. */
public final class RecordingGuard {

    private final DataSet set;
    private final int runs;
    private final Thread hook = new Thread(this::save, "end-of-recording");

    private RecordingGuard(DataSet set, int runs) {
        this.set = set;
        this.runs = runs;
    }

    /**
     * Guards a recording from now on.
     *
     * @param set the data set
     * @param runs how many runs are wanted
     * @return the guard
     */
    public static RecordingGuard begin(DataSet set, int runs) {
        RecordingGuard guard = new RecordingGuard(set, runs);
        Runtime.getRuntime().addShutdownHook(guard.hook);
        return guard;
    }

    /** The recording has ended as it should. */
    public void close() {
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException processEnds) {
            // then the hook is at work
        }
    }

    private void save() {
        try {
            set.endEarly();
            System.err.println("robonewbie: The recording was ended. " + set.runs() + " of " + runs
                    + " runs are complete and kept; the same command goes on.");
        } catch (IOException failure) {
            System.err.println("robonewbie: The table of runs cannot be written: " + failure.getMessage());
        }
        System.err.flush();
        Runtime.getRuntime().halt(1);
    }
}

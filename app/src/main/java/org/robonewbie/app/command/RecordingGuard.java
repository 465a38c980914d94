package org.robonewbie.app.command;

import java.io.IOException;
import java.util.Optional;
import org.robonewbie.learning.dataset.DataSet;
import org.robonewbie.learning.dataset.RunTables;
import org.robonewbie.simulator.server.Simulator;

/**
 * Saves what is recorded if the whole process ends in the middle of it: by Control-C, or since a program calls {@code
 * System.exit}, as agents do after a mistake. A run is kept if it was over, else nothing remains of it.
 */
final class RecordingGuard implements AutoCloseable {

    private static final double CYCLES_PER_SECOND = 50;

    private final DataSet set;
    private final int runs;
    private final double seconds;
    private final Thread hook = new Thread(this::save, "end-of-recording");
    private Optional<Run> current = Optional.empty();

    private record Run(int number, Simulator simulator, RunTables tables) {}

    private RecordingGuard(DataSet set, int runs, double seconds) {
        this.set = set;
        this.runs = runs;
        this.seconds = seconds;
    }

    static RecordingGuard begin(DataSet set, int runs, double seconds) {
        RecordingGuard guard = new RecordingGuard(set, runs, seconds);
        Runtime.getRuntime().addShutdownHook(guard.hook);
        return guard;
    }

    synchronized void begins(int number, Simulator simulator, RunTables tables) {
        current = Optional.of(new Run(number, simulator, tables));
    }

    synchronized void ends() {
        current = Optional.empty();
    }

    /** The recording has ended as it should. */
    @Override
    public void close() {
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException processEnds) {
            // then the hook is at work
        }
    }

    private synchronized void save() {
        String what = current.map(this::save).orElse("The process was ended between two runs.");
        try {
            set.endEarly();
            System.err.println("robonewbie: " + what + " " + set.runs() + " of " + runs
                    + " runs are complete and kept; dataset.json says that the set is not complete.");
        } catch (IOException failure) {
            System.err.println("robonewbie: " + what + " The table of runs cannot be written: " + failure.getMessage());
        }
        System.err.flush();
        Runtime.getRuntime().halt(1);
    }

    private String save(Run run) {
        boolean over = run.simulator.cycles() >= Math.round(seconds * CYCLES_PER_SECOND);
        String words = "The process was ended in run " + run.number
                + ": by Control-C, or the agent called System.exit, as it does after mistakes.";
        try (RunTables tables = run.tables) {
            run.simulator.close();
            if (over) {
                set.add(tables);
            }
            return words;
        } catch (IOException failure) {
            return words + " That run cannot be written: " + failure.getMessage() + ".";
        }
    }
}

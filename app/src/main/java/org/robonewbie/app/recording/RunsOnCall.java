package org.robonewbie.app.recording;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.function.Supplier;
import org.robonewbie.learning.dataset.DataSet;
import org.robonewbie.learning.dataset.RunTables;
import org.robonewbie.programs.Program;
import org.robonewbie.programs.process.ParentProcess;

/**
 * A process that carries out runs, one after the other, whenever it is told the number of one. A program that ends its process, as agents
 * do after a mistake, costs only its own run.
 */
public final class RunsOnCall {

    /** The hidden option of {@code robonewbie record} for such a process. */
    public static final String OPTION = "--on-call";

    /** Begins the answer with what became of a run. */
    static final String RUN = "run ";

    /** The same, and the process ends. */
    static final String LAST_RUN = "last ";

    /** Begins the answer that nothing can be written. */
    static final String STOP = "stop ";

    private final RunOrder order;
    private final Supplier<Program> programs;
    private final DataSet set;
    private final ParentProcess parent = ParentProcess.take();
    private volatile Optional<PlayedRun> current = Optional.empty();

    /**
     * Prepares the process.
     *
     * @param order what is recorded
     * @param programs loads the program for each run, with its own static fields
     * @param set the folder of the tables
     */
    public RunsOnCall(RunOrder order, Supplier<Program> programs, DataSet set) {
        this.order = order;
        this.programs = programs;
        this.set = set;
    }

    /**
     * Carries out runs until no more are wanted. What programs print is left out, but not what they complain about; there may be thousands
     * of runs.
     *
     * @throws InterruptedException if this thread is interrupted
     */
    public void serve() throws InterruptedException {
        System.setOut(new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8));
        Runtime.getRuntime().addShutdownHook(new Thread(this::programEndsTheProcess, "end-of-run"));
        while (true) {
            parent.answer(record(Integer.parseInt(parent.nextCall())));
        }
    }

    private String record(int run) {
        try (RunTables tables = set.begin(run, order.seed(run))) {
            PlayedRun recorded = PlayedRun.begin(order, run, tables);
            current = Optional.of(recorded);
            int code = recorded.play(programs.get());
            current = Optional.empty();
            return RUN + recorded.end(code, "The program failed.").line();
        } catch (IOException unwritable) {
            return STOP + unwritable.getMessage();
        }
    }

    private void programEndsTheProcess() {
        current.ifPresent(recorded -> {
            try {
                parent.answer(LAST_RUN
                        + recorded.end(1, "The program ended its process.").line());
            } catch (IOException unwritable) {
                parent.answer(STOP + unwritable.getMessage());
            }
        });
        Runtime.getRuntime().halt(1);
    }
}

package org.robonewbie.app.recording;

import java.io.BufferedReader;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.function.Supplier;
import org.robonewbie.app.program.AgentProgram;
import org.robonewbie.learning.dataset.DataSet;
import org.robonewbie.learning.dataset.RunTables;

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
    private final Supplier<AgentProgram> programs;
    private final DataSet set;
    private final PrintStream answers = System.out;
    private final FirstWords complaints = FirstWords.listen();
    private volatile Optional<PlayedRun> current = Optional.empty();

    /**
     * Prepares the process.
     *
     * @param order what is recorded
     * @param programs loads the program for each run, with static fields of its own
     * @param set the folder of the tables
     */
    public RunsOnCall(RunOrder order, Supplier<AgentProgram> programs, DataSet set) {
        this.order = order;
        this.programs = programs;
        this.set = set;
    }

    /**
     * Carries out runs until nobody wants any more. What programs print for people is left out; there may be thousands of runs.
     *
     * @throws InterruptedException if somebody interrupts it
     */
    public void serve() throws InterruptedException {
        BlockingQueue<Integer> wanted = new LinkedBlockingQueue<>();
        BufferedReader calls = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        Thread reader = new Thread(() -> listen(calls, wanted), "calls");
        reader.setDaemon(true);
        System.setIn(new ByteArrayInputStream(new byte[0]));
        System.setOut(new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8));
        Runtime.getRuntime().addShutdownHook(new Thread(this::programEndsTheProcess, "end-of-run"));
        reader.start();
        while (true) {
            answer(record(wanted.take()));
        }
    }

    /** When the other process is gone, nobody wants this run any more. */
    private static void listen(BufferedReader calls, BlockingQueue<Integer> wanted) {
        try {
            for (String line = calls.readLine(); line != null; line = calls.readLine()) {
                wanted.add(Integer.valueOf(line));
            }
        } catch (IOException gone) {
            // as if it were the end
        }
        Runtime.getRuntime().halt(0);
    }

    private String record(int run) {
        complaints.forget();
        try (RunTables tables = set.begin(run, order.seed(run))) {
            PlayedRun recorded = PlayedRun.begin(order, run, tables);
            current = Optional.of(recorded);
            int code = recorded.play(programs.get());
            current = Optional.empty();
            return RUN + recorded.end(code, why("The program failed.")).line();
        } catch (IOException unwritable) {
            return STOP + unwritable.getMessage();
        }
    }

    private void programEndsTheProcess() {
        current.ifPresent(recorded -> {
            try {
                answer(LAST_RUN
                        + recorded.end(1, why("The program ended its process.")).line());
            } catch (IOException unwritable) {
                answer(STOP + unwritable.getMessage());
            }
        });
        Runtime.getRuntime().halt(1);
    }

    private String why(String happened) {
        String said = complaints.line();
        return said.isEmpty() ? happened : happened + " It said: " + said;
    }

    private void answer(String text) {
        answers.println(text);
        answers.flush();
    }
}

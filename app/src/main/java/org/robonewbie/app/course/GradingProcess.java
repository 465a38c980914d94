package org.robonewbie.app.course;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicInteger;
import org.robonewbie.app.program.StudentJava;
import org.robonewbie.app.program.TemporaryFolder;
import org.robonewbie.competition.team.ProcessTree;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Grade;
import org.robonewbie.exercises.Performance;
import org.robonewbie.exercises.Score;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.trial.TrialListener;
import org.robonewbie.trial.guest.GuestDoor;

/**
 * Grades a program that runs in a process of its own. World and judge are in this one: the program speaks with them as an agent with a
 * simulator and can tell them nothing but what its robots do. A program that ends its process, takes all memory or never returns costs
 * its author the trial and others nothing.
 */
public final class GradingProcess {

    private static final int SECONDS_AT_LEAST = 60;
    private static final int SECONDS_FOR_EACH_SEED = 20;

    private final Exercise exercise;
    private final String program;
    private final GradingConditions conditions;
    private volatile boolean stuck;
    private int exitCode;

    /**
     * Prepares the grading of one program.
     *
     * @param exercise what it is to solve
     * @param program class or Java file
     * @param conditions how it is graded
     */
    public GradingProcess(Exercise exercise, String program, GradingConditions conditions) {
        this.exercise = exercise;
        this.program = program;
        this.conditions = conditions;
    }

    /**
     * Grades, and waits for the end.
     *
     * @return the grade; none if the program cannot even begin, and why not has been shown
     * @throws IOException if the process cannot be started
     */
    public Optional<Grade> run() throws IOException {
        try (TemporaryFolder folder = TemporaryFolder.create("grade")) {
            return run(folder.path());
        }
    }

    private Optional<Grade> run(Path complaints) throws IOException {
        ProcessBuilder builder = new ProcessBuilder(command(complaints))
                .directory(conditions.folder().toFile())
                .redirectErrorStream(true);
        try (ProcessTree processes = ProcessTree.start(builder, conditions.ownFolder());
                OutputStream calls = processes.process().getOutputStream()) {
            Student student = new Student(processes, calls, complaints);
            StudentOutput output = StudentOutput.of(student, conditions.output());
            List<Grade.SeededScore> scores = judge(student);
            exitCode = student.isReady() ? 0 : student.exitCode();
            student.end();
            output.awaitEnd();
            return student.isReady() ? Optional.of(new Grade(exercise.fullName(), scores)) : Optional.empty();
        }
    }

    /** {@return how the process ended that could not begin} */
    public int exitCode() {
        return exitCode;
    }

    private List<Grade.SeededScore> judge(Student student) {
        ExecutorService threads = Executors.newFixedThreadPool(
                Math.min(conditions.seeds(), conditions.trialsAtOnce()), GradingProcess::daemon);
        List<Future<Score>> trials = new ArrayList<>();
        for (int seed = 1; seed <= conditions.seeds(); seed++) {
            long own = seed;
            trials.add(threads.submit(() -> trial(student, own)));
        }
        List<Grade.SeededScore> scores = new ArrayList<>();
        long end = System.nanoTime()
                + TimeUnit.SECONDS.toNanos(SECONDS_AT_LEAST + (long) SECONDS_FOR_EACH_SEED * conditions.seeds());
        for (Future<Score> trial : trials) {
            scores.add(new Grade.SeededScore(scores.size() + 1, await(trial, end, student)));
        }
        threads.shutdownNow();
        return scores;
    }

    private static Score await(Future<Score> trial, long end, Student student) {
        try {
            return trial.get(Math.max(0, end - System.nanoTime()), TimeUnit.NANOSECONDS);
        } catch (TimeoutException late) {
            return Score.failed(
                    0,
                    "The program took too long.",
                    student.slowness().map(Score::finding).orElse("Does it wait for something that never comes?"));
        } catch (ExecutionException mistake) {
            throw new IllegalStateException("The judge has failed; please report this.", mistake);
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            return Score.failed(0, "The grading was stopped.", "");
        }
    }

    private Score trial(Student student, long seed) throws IOException {
        if (stuck) {
            return Score.notTried();
        }
        AtomicInteger port = new AtomicInteger();
        InetSocketAddress here = new InetSocketAddress(InetAddress.getByAddress(new byte[] {127, 0, 0, 1}), 0);
        try (GuestDoor door = GuestDoor.open(here, 0, guest -> student.isWelcome(port.get(), guest))) {
            port.set(door.port());
            Score score = Performance.of(
                    exercise,
                    seed,
                    () -> new CalledRobot(student, door),
                    seed == 1 ? conditions.recording() : Optional.empty(),
                    TrialListener.NONE);
            Optional<Score> reason = score.passed() ? Optional.empty() : student.reason(door.port());
            stuck |= reason.filter(told -> told.finding().startsWith(Performance.ENDLESS))
                    .isPresent();
            return reason.map(told -> told.finding().isEmpty() ? score.withHint(told.hint()) : told)
                    .orElse(score);
        }
    }

    private List<String> command(Path complaints) {
        List<String> arguments =
                new ArrayList<>(List.of(exercise.name(), program, StudentJava.ON_CALL, complaints.toString()));
        if (!conditions.classPath().isEmpty()) {
            arguments.addAll(List.of("--class-path", conditions.classPath()));
        }
        return StudentJava.grade(List.of(), arguments);
    }

    /**
     * Writes a file in one step, so that half of it is never read.
     *
     * @param file the file, which is replaced
     * @param text what it holds then
     */
    public static void write(Path file, String text) {
        try {
            AtomicFile.write(file, text);
        } catch (IOException unwritable) {
            throw new UncheckedIOException(unwritable.getMessage(), unwritable);
        }
    }

    private static Thread daemon(Runnable work) {
        Thread thread = new Thread(work, "trial");
        thread.setDaemon(true);
        return thread;
    }
}

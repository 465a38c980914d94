package org.robonewbie.web;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Grade;
import org.robonewbie.exercises.marking.ClassService;
import org.robonewbie.pagejvm.Program;
import org.robonewbie.simulator.monitor.RecordedLog;
import org.robonewbie.simulator.recording.RecordingReader;
import org.teavm.jso.JSExport;
import org.teavm.jso.typedarrays.Int8Array;

/**
 * Functions that the page's scripts call while the user is programming, in addition to those of {@link FieldEdition}. Each exported method
 * becomes a function of the WebAssembly module, which is twice as large as that of {@code FieldEdition}.
 */
public final class WebEdition {

    private static final List<byte[]> CLASSES = new ArrayList<>();

    private static @Nullable StudentRun run;

    static {
        FieldEdition.addPrograms(() -> run = null, WebEdition::beginAttempt);
    }

    private WebEdition() {}

    /**
     * Does nothing; the page calls the exported functions.
     *
     * @param args none
     */
    public static void main(String[] args) {}

    /**
     * Converts a recording to a SimSpark server log.
     *
     * @param recording contents of the recording's file
     * @return contents of the log
     * @throws IOException if the file is not a recording
     */
    @JSExport
    public static Int8Array simSparkLog(Int8Array recording) throws IOException {
        ByteArrayOutputStream log = new ByteArrayOutputStream();
        try (RecordingReader reader =
                RecordingReader.of(new ByteArrayInputStream(recording.copyToJavaArray()), "This")) {
            RecordedLog.write(reader, log);
        }
        return Int8Array.copyFromJavaArray(log.toByteArray());
    }

    /**
     * Adds a class of a student's program for {@link #beginProgram}.
     *
     * @param classFile contents of the class file
     */
    @JSExport
    public static void takeClass(Int8Array classFile) {
        CLASSES.add(classFile.copyToJavaArray());
    }

    /** Clears the user's motions in memory before the page passes them again. */
    @JSExport
    public static void forgetMotions() {
        PageMemory.motions().clear();
    }

    /**
     * Adds one of the user's motions, which programs can start by name.
     *
     * @param name name of the motion
     * @param file contents of the motion file
     */
    @JSExport
    public static void takeMotion(String name, Int8Array file) {
        PageMemory.motions().put(name, file.copyToJavaArray());
    }

    /**
     * Starts a world with the program whose classes were added.
     *
     * @param seed random seed
     * @param others class names of example agents that also play, separated by spaces
     * @return why the program cannot run in the page; empty if it runs
     */
    @JSExport
    public static String beginProgram(int seed, String others) {
        return change((program, started) -> PageContext.begin(others, seed, pitch -> pitch.with(program, started)));
    }

    /** {@return whether a student's program is running on the pitch and can be replaced} */
    @JSExport
    public static boolean isProgramRunning() {
        return run != null && run.isRunning() && PageContext.pitch().isPresent();
    }

    /**
     * Replaces the running program with the one whose classes were added; the state of the world is kept.
     *
     * @return why the program cannot run in the page; empty if it runs
     */
    @JSExport
    public static String swapProgram() {
        StudentRun old = Objects.requireNonNull(run, "no program runs");
        return change((program, started) -> PageContext.pitch().orElseThrow().swap(old, program, started));
    }

    /** Loads the program whose classes were added, and starts it. */
    private static String change(BiConsumer<Program, StudentRun> command) {
        StudentRun started = new StudentRun();
        try {
            Program program = loaded(takenClasses());
            command.accept(program, started);
            run = started;
            return "";
        } catch (IllegalArgumentException refused) {
            stopProgram();
            run = null;
            return String.valueOf(refused.getMessage());
        } catch (RuntimeException | Error mistake) {
            started.fail(mistake);
            run = started;
            return "";
        }
    }

    /**
     * Handles a request from the pages for school classes, which need no accounts.
     *
     * @param action name of the request
     * @param request one JSON object
     * @return JSON, or a sentence if the request is rejected
     */
    @JSExport
    public static String classroom(String action, String request) {
        return ClassService.answer(action, request);
    }

    private static ExerciseAttempt beginAttempt(Exercise exercise, long id, int trials, Consumer<Grade> judged) {
        List<byte[]> taken = takenClasses();
        StudentController.agentOf(loaded(taken));
        run = null;
        ExerciseAttempt attempt = new ExerciseAttempt(exercise, taken, id, trials, PageContext.PAGE, judged);
        PageContext.show(attempt);
        return attempt;
    }

    /** {@return the number of classes in the module that only students' programs use} */
    @JSExport
    public static int libraryClasses() {
        return LibraryRoots.count();
    }

    /** {@return state, exit code and output of the student's program, separated by tabs} */
    @JSExport
    public static String programRun() {
        return run == null ? "NONE\t0\t" : run.text();
    }

    /** Stops the student's program and disconnects its robot. */
    @JSExport
    public static void stopProgram() {
        if (run != null) {
            run.stop();
        }
    }

    private static List<byte[]> takenClasses() {
        List<byte[]> taken = List.copyOf(CLASSES);
        CLASSES.clear();
        return taken;
    }

    /** Loads a program and checks that it can run in the page. */
    private static Program loaded(List<byte[]> classes) {
        Program program = new Program(classes);
        List<String> missing = program.missing();
        if (!missing.isEmpty()) {
            throw new IllegalArgumentException("The page does not provide " + String.join(", ", missing)
                    + ". RoboNewbie on your computer supports this.");
        }
        return program;
    }
}

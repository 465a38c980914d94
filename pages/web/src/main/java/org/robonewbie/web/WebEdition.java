package org.robonewbie.web;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.function.BiConsumer;
import org.jspecify.annotations.Nullable;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.exercises.Language;
import org.robonewbie.simulator.monitor.RecordedLog;
import org.robonewbie.simulator.recording.RecordingReader;
import org.robonewbie.studio.PageMotions;
import org.robonewbie.pagejvm.Program;
import org.teavm.jso.JSExport;
import org.teavm.jso.typedarrays.Int8Array;

/**
 * What the scripts of the page call when somebody programs: all that {@link FieldEdition} can do, students' programs and exercises.
 * Each exported method becomes a function of the compiled program.
 */
public final class WebEdition {

    private static final List<byte[]> CLASSES = new ArrayList<>();

    private static @Nullable StudentRun run;
    private static @Nullable ExerciseAttempt attempt;
    private static long attempts;

    private WebEdition() {}

    /**
     * Does nothing: the page calls the functions.
     *
     * @param args none
     */
    public static void main(String[] args) {}

    /**
     * Lets a shipped agent play alone.
     *
     * @param agent name of its class
     * @param seed start of all random numbers
     * @param seconds simulated seconds
     * @return the checksum of the recording, SHA-256 in 64 hexadecimal digits
     */
    @JSExport
    public static String recordingSha256(String agent, int seed, double seconds) {
        return HeadlessRun.of(ShippedAgents.make(agent), seed, seconds).recordingSha256();
    }

    /**
     * Lists the shipped agents.
     *
     * @return the names of their classes, separated by blanks
     */
    @JSExport
    public static String agents() {
        return String.join(" ", ShippedAgents.names());
    }

    /** {@return the robot whose motions are edited, as a JSON object} */
    @JSExport
    public static String robot() {
        return PageMotions.robot();
    }

    /**
     * Lets a robot with weight and motors play a motion.
     *
     * @param text the motion's file
     * @param start how the robot is before
     * @return what happened, as a JSON object; or why that cannot be, as a sentence
     */
    @JSExport
    public static String motionTrial(String text, String start) {
        return PageContext.motionTrial(text, start);
    }

    /** {@return the bodies of all robot types, as a JSON object} */
    @JSExport
    public static String models() {
        return PageMotions.models();
    }

    /**
     * Turns a recording into the log of a SimSpark server.
     *
     * @param recording the bytes of a recording's file
     * @return those of the log
     * @throws IOException if it is no recording; the message says so
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

    /** Forgets the scenes that the page has handed over, before it does so once more. */
    @JSExport
    public static void forgetScenes() {
        PageContext.scenes().clear();
    }

    /**
     * Takes a scene that the browser keeps.
     *
     * @param name of the scene
     * @param bytes the scene
     */
    @JSExport
    public static void takeScene(String name, Int8Array bytes) {
        PageContext.scenes().take(name, bytes.copyToJavaArray());
    }

    /**
     * Saves, renames, removes or lists scenes, or goes back to one.
     *
     * @param method PUT, DELETE, POST, or GET for the list
     * @param name the scene
     * @param old the scene that is renamed; empty if none is
     * @return one JSON object; or why that cannot be, as a sentence
     */
    @JSExport
    public static String scenes(String method, String name, String old) {
        return PageContext.scenes(method, name, old);
    }

    /**
     * Goes on from a moment of a recording.
     *
     * @param recording its bytes, not compressed
     * @param state number of the moment, from 0
     * @return one JSON object; or why that cannot be, as a sentence
     */
    @JSExport
    public static String startFrom(Int8Array recording, int moment) {
        return PageContext.startFrom(recording.copyToJavaArray(), moment);
    }

    /**
     * Does what the page asks for.
     *
     * @param command one JSON object
     */
    @JSExport
    public static void ask(String command) {
        PageContext.ask(command);
    }

    /**
     * Begins a world with shipped agents, which is shown from now on.
     *
     * @param agents names of their classes, separated by blanks
     * @param seed start of all random numbers
     */
    @JSExport
    public static void begin(String agents, int seed) {
        leave();
        PageContext.begin(agents, seed);
    }

    /**
     * Lets one more shipped agent enter the world that is shown.
     *
     * @param agent name of its class
     */
    @JSExport
    public static void join(String agent) {
        PageContext.join(agent);
    }

    /**
     * Lets the shown world go on.
     *
     * @param seconds how long the last turn is ago
     */
    @JSExport
    public static void turn(double seconds) {
        if (attempt != null) {
            attempt.turn(seconds);
        } else {
            PageContext.turn(seconds);
        }
    }

    /**
     * Takes a class of a student's program, which {@link #beginProgram} runs together with the others.
     *
     * @param classFile what the compiler has made
     */
    @JSExport
    public static void takeClass(Int8Array classFile) {
        CLASSES.add(classFile.copyToJavaArray());
    }

    /** Forgets the motions that the page has handed over, before it does so once more. */
    @JSExport
    public static void forgetMotions() {
        PageMemory.motions().clear();
    }

    /**
     * Takes a motion of the page, which programs start by its name.
     *
     * @param name of the motion
     * @param file the bytes of its file
     */
    @JSExport
    public static void takeMotion(String name, Int8Array file) {
        PageMemory.motions().put(name, file.copyToJavaArray());
    }

    /**
     * Begins a world with the program whose classes were taken.
     *
     * @param seed start of all random numbers
     * @param others names of the shipped agents that play as well, separated by blanks
     * @return why the program cannot run here; empty if it runs
     */
    @JSExport
    public static String beginProgram(int seed, String others) {
        return change((program, begun) -> {
            leave();
            PageContext.begin(others, seed, pitch -> pitch.with(program, begun));
        });
    }

    /** {@return whether a program of a student runs on the pitch, so that another one can take its place} */
    @JSExport
    public static boolean isProgramRunning() {
        return run != null && run.isRunning() && PageContext.pitch().isPresent();
    }

    /**
     * Lets the program whose classes were taken take the place of the one that runs, while the world stays.
     *
     * @return why the program cannot run here; empty if it runs
     */
    @JSExport
    public static String swapProgram() {
        StudentRun old = Objects.requireNonNull(run, "no program runs");
        return change((program, begun) -> PageContext.pitch().orElseThrow().swap(old, program, begun));
    }

    /** Loads the program whose classes were taken, and does what lets it play. */
    private static String change(BiConsumer<Program, StudentRun> command) {
        StudentRun begun = new StudentRun();
        try {
            Program program = loaded(takenClasses());
            command.accept(program, begun);
            run = begun;
            return "";
        } catch (IllegalArgumentException refused) {
            stopProgram();
            run = null;
            return String.valueOf(refused.getMessage());
        } catch (RuntimeException | Error mistake) {
            begun.fail(mistake);
            run = begun;
            return "";
        }
    }

    /**
     * Begins to try an exercise with the program whose classes were taken; its trials are shown.
     *
     * @param exercise name of the exercise
     * @param trials how many seeds are tried
     * @return why that cannot be; empty if it has begun
     */
    @JSExport
    public static String beginExercise(String exercise, int trials) {
        try {
            List<byte[]> taken = takenClasses();
            StudentPerformer.agentOf(loaded(taken));
            leave();
            attempts++;
            attempt = new ExerciseAttempt(find(exercise), taken, attempts, trials, PageContext.PAGE);
            PageContext.show(attempt.world());
            return "";
        } catch (IllegalArgumentException refused) {
            return String.valueOf(refused.getMessage());
        }
    }

    /**
     * Writes how the exercise goes on.
     *
     * @param language of findings and hints, two letters
     * @return one JSON object; empty if none is tried
     */
    @JSExport
    public static String attempt(String language) {
        return attempt == null ? "" : attempt.json(Language.of(language).orElse(Language.ENGLISH));
    }

    /**
     * Judges one trial of the program whose classes were taken, as fast as possible and without a picture.
     *
     * @param exercise name of the exercise
     * @param seed start of all that is left to chance
     * @return the score as a JSON object
     */
    @JSExport
    public static String score(String exercise, int seed) {
        return ExerciseAttempt.json(seed, ExerciseAttempt.score(find(exercise), takenClasses(), seed))
                .toString();
    }

    private static Exercise find(String exercise) {
        return Exercises.find(exercise)
                .orElseThrow(() -> new IllegalArgumentException("There is no exercise \"" + exercise + "\"."));
    }

    /** {@return how many classes are in the page for programs of students only} */
    @JSExport
    public static int libraryClasses() {
        return LibraryRoots.count();
    }

    /** {@return how the student's program runs: state, exit code and what it has printed, with tabs between them} */
    @JSExport
    public static String programRun() {
        return run == null ? "NONE\t0\t" : run.text();
    }

    /** Stops the student's program; its robot leaves. */
    @JSExport
    public static void stopProgram() {
        if (run != null) {
            run.stop();
        }
    }

    private static void leave() {
        run = null;
        attempt = null;
    }

    private static List<byte[]> takenClasses() {
        List<byte[]> taken = List.copyOf(CLASSES);
        CLASSES.clear();
        return taken;
    }

    /** Loads a program, so that it is known to run here. */
    private static Program loaded(List<byte[]> classes) {
        Program program = new Program(classes);
        List<String> missing = program.missing();
        if (!missing.isEmpty()) {
            throw new IllegalArgumentException(
                    "The page does not have " + String.join(", ", missing) + ". RoboNewbie on your computer has it.");
        }
        return program;
    }
}

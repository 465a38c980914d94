package org.robonewbie.web;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.robonewbie.studio.PageFeed;
import org.robonewbie.web.bytecode.Program;
import org.teavm.jso.JSBody;
import org.teavm.jso.JSExport;
import org.teavm.jso.typedarrays.Int8Array;

/** What the scripts of the page call; each exported method becomes a function of the compiled program. */
public final class WebEdition {

    private static final List<byte[]> CLASSES = new ArrayList<>();

    private static @Nullable LiveWorld world;
    private static @Nullable StudentRun run;

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

    /**
     * Begins a world with a shipped agent, which is shown from now on.
     *
     * @param agent name of its class
     * @param seed start of all random numbers
     */
    @JSExport
    public static void begin(String agent, int seed) {
        run = null;
        world = new LiveWorld(agent, seed, new Page());
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

    /**
     * Begins a world with the program whose classes were taken.
     *
     * @param seed start of all random numbers
     * @return why the program cannot run here; empty if it runs
     */
    @JSExport
    public static String beginProgram(int seed) {
        List<byte[]> taken = List.copyOf(CLASSES);
        CLASSES.clear();
        StudentRun begun = new StudentRun();
        try {
            Program program = new Program(taken);
            List<String> missing = program.missing();
            if (!missing.isEmpty()) {
                return "The page does not have " + String.join(", ", missing) + ". RoboNewbie on your computer has it.";
            }
            run = begun;
            world = new LiveWorld(program, begun, seed, new Page());
            return "";
        } catch (IllegalArgumentException refused) {
            return String.valueOf(refused.getMessage());
        } catch (RuntimeException | Error mistake) {
            begun.fail(mistake);
            return "";
        }
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

    /**
     * Does what the page asks for.
     *
     * @param command one JSON object
     */
    @JSExport
    public static void ask(String command) {
        if (world != null) {
            world.ask(command);
        }
    }

    /**
     * Lets the shown world go on.
     *
     * @param seconds how long the last turn is ago
     */
    @JSExport
    public static void turn(double seconds) {
        if (world != null) {
            world.turn(seconds);
        }
    }

    /** The page behind this worker. */
    private static final class Page implements PageFeed.Page {

        @Override
        public void tell(String json) {
            post(json);
        }

        @Override
        public void show(byte[] frame) {
            post(Int8Array.copyFromJavaArray(frame));
        }
    }

    @JSBody(params = "json", script = "self.postMessage(json);")
    private static native void post(String json);

    @JSBody(params = "frame", script = "self.postMessage(frame.buffer, [frame.buffer]);")
    private static native void post(Int8Array frame);
}

package org.robonewbie.web;

import org.robonewbie.studio.PageMotions;
import org.teavm.jso.JSExport;
import org.teavm.jso.typedarrays.Int8Array;

/**
 * What the scripts of the page call as long as nobody programs: shipped agents play, and motions are tried. Each exported method
 * becomes a function of the compiled program, which is half as large as that of {@link WebEdition}.
 */
public final class FieldEdition {

    private FieldEdition() {}

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
        PageContext.turn(seconds);
    }
}

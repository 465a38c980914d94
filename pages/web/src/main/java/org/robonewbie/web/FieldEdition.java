package org.robonewbie.web;

import org.robonewbie.studio.PageMotions;
import org.teavm.jso.JSExport;
import org.teavm.jso.typedarrays.Int8Array;

/**
 * Functions that the page's scripts call: they run example agents, try out motions and handle requests. Each exported method becomes a
 * function of the WebAssembly module; in the module of {@link WebEdition}, it is a static method of this class.
 */
public final class FieldEdition {

    private FieldEdition() {}

    /**
     * Adds support for students' programs to the page.
     *
     * @param left called when the user leaves the current world, before another is shown
     * @param starter starts an attempt at an exercise
     */
    static void addPrograms(Runnable left, PageCourse.Starter starter) {
        PageContext.addPrograms(left, starter);
    }

    /**
     * Does nothing; the page calls the exported functions.
     *
     * @param args none
     */
    public static void main(String[] args) {}

    /**
     * Runs an example agent alone, without a display.
     *
     * @param agent class name of the agent
     * @param seed random seed
     * @param seconds simulated seconds
     * @return checksum of the recording: SHA-256 in 64 hexadecimal digits
     */
    @JSExport
    public static String recordingSha256(String agent, int seed, double seconds) {
        return HeadlessRun.of(ShippedAgents.make(agent), seed, seconds).recordingSha256();
    }

    /**
     * Lists the example agents.
     *
     * @return the class names of the agents, separated by spaces
     */
    @JSExport
    public static String agents() {
        return String.join(" ", ShippedAgents.names());
    }

    /**
     * Describes a robot for the motion editor.
     *
     * @param name name of a model other than the NAO's; empty for the NAO
     * @return the description as a JSON object, or a sentence if there is no such model
     */
    @JSExport
    public static String robot(String name) {
        return PageContext.robot(name);
    }

    /**
     * Plays a motion on a robot with full physics.
     *
     * @param text contents of the motion file
     * @param start initial posture
     * @return the result as a JSON object, or a sentence if the motion is rejected
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
     * Handles a request to a service.
     *
     * @param service {@code course}, {@code scenes} or {@code recordings}
     * @param request one JSON object with the request and the browser's stored data
     * @return JSON, or a sentence if the request is rejected
     */
    @JSExport
    public static String answer(String service, String request) {
        return PageContext.answer(service, request);
    }

    /**
     * Parses the next bytes of a recording that the browser has stored.
     *
     * @param id identifier of the recording
     * @param from offset of the bytes in the uncompressed recording
     * @param bytes the bytes; ignored if others must be parsed first
     * @return offset of the bytes to be passed next
     */
    @JSExport
    public static int readRecording(String id, int from, Int8Array bytes) {
        return PageContext.recordings().read(id, from, bytes.copyToJavaArray());
    }

    /**
     * Continues the simulation from a cycle of a recording.
     *
     * @param recording the uncompressed bytes of the recording
     * @param moment zero-based index of the cycle
     * @return one JSON object, or a sentence if the request is rejected
     */
    @JSExport
    public static String startFrom(Int8Array recording, int moment) {
        return PageContext.startFrom(recording.copyToJavaArray(), moment);
    }

    /**
     * Executes a command from the page.
     *
     * @param command one JSON object
     */
    @JSExport
    public static void ask(String command) {
        PageContext.ask(command);
    }

    /**
     * Starts a world with example agents and shows it.
     *
     * @param agents class names of the agents, separated by spaces
     * @param seed random seed
     */
    @JSExport
    public static void begin(String agents, int seed) {
        PageContext.begin(agents, seed);
    }

    /**
     * Adds an example agent to the displayed world.
     *
     * @param agent class name of the agent
     */
    @JSExport
    public static void join(String agent) {
        PageContext.join(agent);
    }

    /**
     * Advances the displayed world.
     *
     * @param seconds time since the last call
     */
    @JSExport
    public static void turn(double seconds) {
        PageContext.turn(seconds);
    }
}

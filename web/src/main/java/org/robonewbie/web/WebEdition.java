package org.robonewbie.web;

import org.jspecify.annotations.Nullable;
import org.robonewbie.studio.PageFeed;
import org.teavm.jso.JSBody;
import org.teavm.jso.JSExport;
import org.teavm.jso.typedarrays.Int8Array;

/** What the scripts of the page call; each exported method becomes a function of the compiled program. */
public final class WebEdition {

    private static @Nullable LiveWorld world;

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
        world = new LiveWorld(agent, seed, new PageFeed.Page() {

            @Override
            public void tell(String json) {
                post(json);
            }

            @Override
            public void show(byte[] frame) {
                post(Int8Array.copyFromJavaArray(frame));
            }
        });
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

    @JSBody(params = "json", script = "self.postMessage(json);")
    private static native void post(String json);

    @JSBody(params = "frame", script = "self.postMessage(frame.buffer, [frame.buffer]);")
    private static native void post(Int8Array frame);
}

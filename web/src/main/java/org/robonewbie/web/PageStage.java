package org.robonewbie.web;

import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.robonewbie.simulator.recording.RecordingTarget;
import org.robonewbie.studio.PageFeed;
import org.robonewbie.studio.PageMotions;
import org.robonewbie.studio.file.RefusedException;
import org.teavm.jso.JSBody;
import org.teavm.jso.typedarrays.Int8Array;

/** The world that the page shows, and what can be done with each. */
final class PageStage {

    /** The page behind this worker. */
    static final PageFeed.Page PAGE = new Page();

    private static @Nullable LiveWorld world;
    private static MemoryRecording recording = new MemoryRecording();
    private static int recordings;

    private PageStage() {}

    /** Shows a shipped agent that plays alone. */
    static void begin(String agent, int seed) {
        show(feed -> new FreePitch(seed, feed, record()).with(ShippedAgents.make(agent)));
    }

    /** Begins another recording, which takes the place of the last one. */
    static RecordingTarget record() {
        recordings++;
        recording = new MemoryRecording();
        return recording;
    }

    /** Counts the recordings that were begun. */
    static int recordingNumber() {
        return recordings;
    }

    /** Reads the last recording behind the bytes that are known. */
    static Int8Array recordingFrom(int known) {
        return Int8Array.copyFromJavaArray(recording.read(known));
    }

    /** Shows a world from now on. */
    static void show(Function<PageFeed, ? extends WatchedWorld> maker) {
        show(new LiveWorld(PAGE, maker));
    }

    /** Shows a world from now on. */
    static void show(LiveWorld next) {
        world = next;
    }

    /** Does what the page asks for with one JSON object. */
    static void ask(String command) {
        if (world != null) {
            world.ask(command);
        }
    }

    /** Lets the shown world go on; the last turn is some seconds ago. */
    static void turn(double seconds) {
        if (world != null) {
            world.turn(seconds);
        }
    }

    /** Lets a robot with weight play a motion; returns what happened as JSON, or why that cannot be as a sentence. */
    static String motionTrial(String text, String start) {
        try {
            return PageMotions.trial(text, start);
        } catch (RefusedException refused) {
            return String.valueOf(refused.getMessage());
        }
    }

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

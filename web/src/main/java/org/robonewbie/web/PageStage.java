package org.robonewbie.web;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
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
    private static Optional<FreePitch> pitch = Optional.empty();
    private static MemoryRecording recording = new MemoryRecording();
    private static int recordings;

    private PageStage() {}

    /** Shows shipped agents, whose names have blanks between them. */
    static void begin(String agents, int seed) {
        begin(agents, seed, empty -> {});
    }

    /** Shows somebody and, after that, shipped agents whose names have blanks between them. */
    static void begin(String agents, int seed, Consumer<FreePitch> first) {
        world = new LiveWorld(PAGE, feed -> {
            FreePitch begun = new FreePitch(seed, feed, record());
            pitch = Optional.of(begun);
            return begun;
        });
        pitch.ifPresent(first);
        named(agents).forEach(PageStage::join);
    }

    private static List<String> named(String agents) {
        return Arrays.stream(agents.split(" ", -1))
                .filter(name -> !name.isEmpty())
                .toList();
    }

    /** Lets one more shipped agent enter the world that is shown. */
    static void join(String agent) {
        pitch.ifPresent(shown -> shown.with(ShippedAgents.make(agent)));
    }

    /** {@return the pitch that is shown; empty while an exercise is} */
    static Optional<FreePitch> pitch() {
        return pitch;
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

    /** Shows the trials of an exercise from now on. */
    static void show(LiveWorld trials) {
        world = trials;
        pitch = Optional.empty();
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

package org.robonewbie.web;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.robonewbie.simulator.recording.RecordingTarget;
import org.robonewbie.studio.PageFeed;
import org.robonewbie.studio.PageMotions;
import org.robonewbie.studio.PageScenes;
import org.robonewbie.studio.file.RefusedException;
import org.robonewbie.studio.scene.SceneRepository;
import org.teavm.jso.JSBody;
import org.teavm.jso.typedarrays.Int8Array;

/** The displayed world and its commands. */
final class PageContext {

    /** The page that owns this worker. */
    static final PageFeed.Page PAGE = new Page();

    private static final PageScenes SCENES = new PageScenes(new Browser());

    /** Recordings to send. The last one belongs to the displayed world; earlier ones have not been sent completely. */
    private static final Deque<PageRecording> RECORDINGS = new ArrayDeque<>();

    private static @Nullable PacedWorld world;
    private static Optional<FreePitch> pitch = Optional.empty();

    private PageContext() {}

    /** Shows shipped agents, given as class names separated by spaces. */
    static void begin(String agents, int seed) {
        begin(agents, seed, empty -> {});
    }

    /** Shows a world with a first participant and then shipped agents, given as class names separated by spaces. */
    static void begin(String agents, int seed, Consumer<FreePitch> first) {
        world = new PacedWorld(PAGE, feed -> {
            FreePitch started = new FreePitch(seed, feed, record());
            pitch = Optional.of(started);
            return started;
        });
        pitch.ifPresent(first);
        named(agents).forEach(PageContext::join);
    }

    private static List<String> named(String agents) {
        return Arrays.stream(agents.split(" ", -1))
                .filter(name -> !name.isEmpty())
                .toList();
    }

    /** Adds a shipped agent to the displayed world. */
    static void join(String agent) {
        pitch.ifPresent(shown -> shown.with(ShippedAgents.make(agent)));
    }

    /** {@return the displayed pitch; empty during an exercise} */
    static Optional<FreePitch> pitch() {
        return pitch;
    }

    /** Starts a new recording, which replaces the current one. */
    static RecordingTarget record() {
        RECORDINGS.add(new PageRecording());
        return RECORDINGS.getLast();
    }

    private static void sendRecordings() {
        RECORDINGS.forEach(each -> each.sendTo(PageContext::postRecorded));
        while (RECORDINGS.size() > 1) {
            RECORDINGS.removeFirst();
        }
    }

    /** Shows the trials of an exercise. */
    static void show(PacedWorld trials) {
        world = trials;
        pitch = Optional.empty();
    }

    /** Executes a command from the page, one JSON object. */
    static void ask(String command) {
        if (world != null) {
            world.ask(command);
        }
    }

    /** Advances the displayed world; {@code seconds} is the time since the last call. */
    static void turn(double seconds) {
        if (world != null) {
            world.turn(seconds);
            sendRecordings();
        }
    }

    /** Plays a motion on a robot with full physics; returns the result as JSON, or a sentence if the motion is refused. */
    static String motionTrial(String text, String start) {
        try {
            return PageMotions.trial(text, start);
        } catch (RefusedException refused) {
            return String.valueOf(refused.getMessage());
        }
    }

    /** Returns the scenes, which the browser passes before each request. */
    static SceneRepository scenes() {
        return SCENES.repository();
    }

    /** Saves, renames, deletes, restores or lists scenes; returns a JSON object, or a sentence if the request is refused. */
    static String scenes(String method, String name, String old) {
        return answer(feed -> SCENES.answer(feed, method, name, old));
    }

    /** Continues the simulation from a cycle of a recording; returns a JSON object, or a sentence if the request is refused. */
    static String startFrom(byte[] recorded, int moment) {
        return answer(feed -> SCENES.start(feed, recorded, moment));
    }

    private static String answer(Function<PageFeed, String> request) {
        try {
            return world == null ? "The simulation has not started yet." : request.apply(world.feed());
        } catch (RefusedException refused) {
            return String.valueOf(refused.getMessage());
        }
    }

    private static final class Browser implements SceneRepository.Keeper {

        @Override
        public void keep(String name, byte[] scene) {
            keepScene(name, Int8Array.copyFromJavaArray(scene));
        }

        @Override
        public void forget(String name) {
            forgetScene(name);
        }
    }

    @JSBody(
            params = {"name", "bytes"},
            script = "self.postMessage({ scene: { name: name, bytes: bytes } });")
    private static native void keepScene(String name, Int8Array bytes);

    @JSBody(params = "name", script = "self.postMessage({ scene: { name: name } });")
    private static native void forgetScene(String name);

    private static final class Page implements PageFeed.Page {

        @Override
        public void send(String json) {
            post(json);
        }

        @Override
        public void show(byte[] frame) {
            post(Int8Array.copyFromJavaArray(frame));
        }

        @Override
        public void keep(String note) {
            sendRecordings();
            postNote(note);
        }
    }

    private static void postRecorded(byte[] bytes, boolean first) {
        postRecorded(Int8Array.copyFromJavaArray(bytes), first);
    }

    @JSBody(
            params = {"bytes", "first"},
            script = "self.postMessage({recorded: new Uint8Array(bytes.buffer), first: first}, [bytes.buffer]);")
    private static native void postRecorded(Int8Array bytes, boolean first);

    @JSBody(params = "note", script = "self.postMessage({noted: note});")
    private static native void postNote(String note);

    @JSBody(params = "json", script = "self.postMessage(json);")
    private static native void post(String json);

    @JSBody(params = "frame", script = "self.postMessage(frame.buffer, [frame.buffer]);")
    private static native void post(Int8Array frame);
}

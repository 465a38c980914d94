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

/** The world that the page shows, and what can be done with each. */
final class PageContext {

    /** The page behind this worker. */
    static final PageFeed.Page PAGE = new Page();

    private static final PageScenes SCENES = new PageScenes(new Browser());

    /** The last one is that of the world that is shown; of others the page has not got all yet. */
    private static final Deque<PageRecording> RECORDINGS = new ArrayDeque<>();

    private static @Nullable PacedWorld world;
    private static Optional<FreePitch> pitch = Optional.empty();

    private PageContext() {}

    /** Shows shipped agents, whose names have blanks between them. */
    static void begin(String agents, int seed) {
        begin(agents, seed, empty -> {});
    }

    /** Shows somebody and, after that, shipped agents whose names have blanks between them. */
    static void begin(String agents, int seed, Consumer<FreePitch> first) {
        world = new PacedWorld(PAGE, feed -> {
            FreePitch begun = new FreePitch(seed, feed, record());
            pitch = Optional.of(begun);
            return begun;
        });
        pitch.ifPresent(first);
        named(agents).forEach(PageContext::join);
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
        RECORDINGS.add(new PageRecording());
        return RECORDINGS.getLast();
    }

    private static void giveRecorded() {
        RECORDINGS.forEach(each -> each.give(PageContext::postRecorded));
        while (RECORDINGS.size() > 1) {
            RECORDINGS.removeFirst();
        }
    }

    /** Shows the trials of an exercise from now on. */
    static void show(PacedWorld trials) {
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
            giveRecorded();
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

    /** The scenes, which the browser hands over before each request. */
    static SceneRepository scenes() {
        return SCENES.repository();
    }

    /** Saves, renames, removes or lists scenes, or goes back to one; returns a JSON object, or why that cannot be as a sentence. */
    static String scenes(String method, String name, String old) {
        return answer(feed -> SCENES.answer(feed, method, name, old));
    }

    /** Goes on from a moment of a recording; returns a JSON object, or why that cannot be as a sentence. */
    static String startFrom(byte[] recorded, int moment) {
        return answer(feed -> SCENES.start(feed, recorded, moment));
    }

    private static String answer(Function<PageFeed, String> request) {
        try {
            return world == null ? "The world has not begun yet." : request.apply(world.feed());
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
        public void tell(String json) {
            post(json);
        }

        @Override
        public void show(byte[] frame) {
            post(Int8Array.copyFromJavaArray(frame));
        }

        @Override
        public void keep(String note) {
            giveRecorded();
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

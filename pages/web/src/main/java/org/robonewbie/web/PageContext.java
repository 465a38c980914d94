package org.robonewbie.web;

import java.io.ByteArrayInputStream;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import org.jspecify.annotations.Nullable;
import org.robonewbie.simulator.recording.RecordingReader;
import org.robonewbie.simulator.recording.RecordingTarget;
import org.robonewbie.studio.PageFeed;
import org.robonewbie.studio.PageMotions;
import org.robonewbie.studio.file.RefusedException;
import org.robonewbie.studio.scene.SceneService;
import org.teavm.jso.JSBody;
import org.teavm.jso.typedarrays.Int8Array;

/** The displayed world and its commands. */
final class PageContext {

    /** The page that started this worker. */
    static final PageFeed.Page PAGE = new Page();

    private static final PageScenes SCENES = new PageScenes();
    private static final PageRecordings STORED = new PageRecordings();
    private static final String NOT_STARTED = "The simulation has not started yet.";

    /** Recordings to send. The last one belongs to the displayed world; earlier ones have not yet been sent completely. */
    private static final Deque<PageRecording> RECORDINGS = new ArrayDeque<>();

    private static final PageCourse COURSE = new PageCourse();

    private static Runnable leave = () -> {};
    private static @Nullable PacedWorld world;
    private static DoubleConsumer turn = seconds -> {};
    private static Optional<FreePitch> pitch = Optional.empty();

    private PageContext() {}

    /**
     * Adds support for students' programs to the page.
     *
     * @param left called when the user leaves the current world, before another is shown
     * @param started starts an attempt at an exercise
     */
    static void addPrograms(Runnable left, PageCourse.Starter started) {
        leave = left;
        COURSE.startWith(started);
    }

    /** Shows a world with example agents, given as class names separated by spaces. */
    static void begin(String agents, int seed) {
        begin(agents, seed, empty -> {});
    }

    /** Shows a world with a first participant and example agents, which are given as class names separated by spaces. */
    static void begin(String agents, int seed, Consumer<FreePitch> first) {
        leave.run();
        COURSE.close();
        PacedWorld shown = new PacedWorld(PAGE, feed -> {
            FreePitch started = new FreePitch(seed, feed, record());
            pitch = Optional.of(started);
            return started;
        });
        world = shown;
        turn = shown::turn;
        pitch.ifPresent(first);
        named(agents).forEach(PageContext::join);
    }

    private static List<String> named(String agents) {
        return Arrays.stream(agents.split(" ", -1))
                .filter(name -> !name.isEmpty())
                .toList();
    }

    /** Adds an example agent to the displayed world. */
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
    static void show(ExerciseAttempt attempt) {
        world = attempt.world();
        turn = attempt::turn;
        pitch = Optional.empty();
    }

    /** Executes a command from the page, given as a JSON object. */
    static void ask(String command) {
        if (world != null) {
            world.ask(command);
        }
    }

    /** Advances the displayed world; {@code seconds} is the time since the last call. */
    static void turn(double seconds) {
        turn.accept(seconds);
        sendRecordings();
    }

    /** Describes a robot for the motion editor; returns JSON, or a sentence if there is no such robot. */
    static String robot(String name) {
        try {
            return PageMotions.robot(name);
        } catch (RefusedException refused) {
            return String.valueOf(refused.getMessage());
        }
    }

    /** Plays a motion on a robot with full physics; returns the result as JSON, or a sentence if the motion is rejected. */
    static String motionTrial(String text, String start) {
        try {
            return PageMotions.trial(text, start);
        } catch (RefusedException refused) {
            return String.valueOf(refused.getMessage());
        }
    }

    /** Handles a request to a service; returns JSON, or a sentence if the request is rejected. */
    static String answer(String service, String text) {
        ServiceRequest request = ServiceRequest.parse(text);
        return switch (service) {
            case "course" -> COURSE.answer(request);
            case "recordings" -> STORED.answer(request);
            default -> world == null ? NOT_STARTED : SCENES.answer(request, world.feed());
        };
    }

    /** Returns the recordings that the browser has stored. */
    static PageRecordings recordings() {
        return STORED;
    }

    /** Continues the simulation from a cycle of a recording; returns a JSON object, or a sentence if the request is rejected. */
    static String startFrom(byte[] recorded, int moment) {
        PacedWorld shown = world;
        return shown == null
                ? NOT_STARTED
                : ServiceRequest.attempt(() -> shown.feed()
                        .scenes(SCENES)
                        .start(
                                RecordingReader.ofUnpacked(new ByteArrayInputStream(recorded), "This"),
                                moment,
                                SceneService.ENDS_BEFORE));
    }

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
            post("noted", note);
        }
    }

    private static void postRecorded(byte[] bytes, boolean first) {
        postRecorded(Int8Array.copyFromJavaArray(bytes), first);
    }

    @JSBody(
            params = {"bytes", "first"},
            script = "self.postMessage({recorded: new Uint8Array(bytes.buffer), first: first}, [bytes.buffer]);")
    private static native void postRecorded(Int8Array bytes, boolean first);

    /** Sends a change to the page, which stores it. */
    @JSBody(
            params = {"name", "text"},
            script = "var message = {}; message[name] = text; self.postMessage(message);")
    static native void post(String name, String text);

    @JSBody(params = "json", script = "self.postMessage(json);")
    private static native void post(String json);

    @JSBody(params = "frame", script = "self.postMessage(frame.buffer, [frame.buffer]);")
    private static native void post(Int8Array frame);
}

package org.robonewbie.learning.environment;

import com.google.gson.Gson;
import com.google.gson.JsonObject;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.robonewbie.agent.policy.MotionGuide;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.policy.PolicyText;
import org.robonewbie.agent.policy.Quantity;
import org.robonewbie.simulator.embedded.Viewer;

/** Connection to one client. It creates the client's environments and steps them; see docs/gym-protocol.md. */
final class EnvironmentConnection {

    private static final Gson GSON = new Gson();
    private static final int MAX_MESSAGE_BYTES = 64 << 20;
    private static final int MAX_ENVIRONMENTS = 1024;
    private static final byte MAKE = 'M';
    private static final byte MAKE_WITHOUT_PHYSICS = 'X';
    private static final byte ACT = 'A';
    private static final byte POLICY = 'L';
    private static final byte CHANGE = 'C';
    private static final byte PICTURE = 'P';
    private static final byte VIEW = 'V';
    private static final byte OK = 0;
    private static final byte ERROR = 1;
    private static final byte ADVANCE = 2;

    private final DataInputStream input;
    private final DataOutputStream output;
    private final ClassLoader classes;
    private final Viewer viewer;
    private VectorEnvironment environments = VectorEnvironment.NONE;
    private final List<EnvironmentRenderer> renderers = new ArrayList<>();

    EnvironmentConnection(DataInputStream input, DataOutputStream output, ClassLoader classes, Viewer viewer) {
        this.input = input;
        this.output = output;
        this.classes = classes;
        this.viewer = viewer;
    }

    /** Handles requests until the connection is closed. */
    void serve() throws IOException {
        try {
            while (true) {
                answer(readMessage());
            }
        } catch (EOFException left) {
            // The client has closed the connection.
        } finally {
            end();
        }
    }

    private void end() {
        renderers.forEach(EnvironmentRenderer::close);
        renderers.clear();
        environments.close();
    }

    private ByteBuffer readMessage() throws IOException {
        int length = Integer.reverseBytes(input.readInt());
        if (length < 1 || length > MAX_MESSAGE_BYTES) {
            throw new IOException("A learning program sent a message of " + length
                    + " bytes. Are both sides the same version of RoboNewbie?");
        }
        byte[] bytes = new byte[length];
        input.readFully(bytes);
        return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    }

    private void answer(ByteBuffer request) throws IOException {
        try {
            byte kind = request.get();
            switch (kind) {
                case MAKE -> reply(OK, make(request, false));
                case MAKE_WITHOUT_PHYSICS -> reply(OK, make(request, true));
                case POLICY -> reply(OK, setPolicy(request));
                case ACT -> reply(OK, environments.act(request));
                case CHANGE -> reply(OK, change(request));
                case PICTURE -> reply(OK, picture(request));
                case VIEW -> reply(OK, view(request));
                default -> throw new IllegalArgumentException("There is no request of kind " + kind + ".");
            }
        } catch (IllegalArgumentException | java.nio.BufferUnderflowException wrong) {
            reply(ERROR, String.valueOf(wrong.getMessage()).getBytes(StandardCharsets.UTF_8));
        }
    }

    private void reply(byte status, byte[] content) throws IOException {
        ByteBuffer frame = ByteBuffer.allocate(5 + content.length).order(ByteOrder.LITTLE_ENDIAN);
        frame.putInt(1 + content.length).put(status).put(content);
        output.write(frame.array());
        output.flush();
    }

    private byte[] make(ByteBuffer request, boolean withoutPhysics) {
        int count = request.getInt();
        if (count < 1 || count > MAX_ENVIRONMENTS) {
            throw new IllegalArgumentException(
                    count + " environments were requested; request 1 to " + MAX_ENVIRONMENTS + ".");
        }
        List<String> lines = text(request).lines().toList();
        EnvironmentSpec spec = new EnvironmentSpec(
                lines.stream().findFirst().orElse(""), lines.stream().skip(1).toList());
        Supplier<List<EpisodeRunner>> runners = spec.runners(classes);
        DomainRandomization options = spec.randomization();
        end();
        environments = VectorEnvironment.of(
                count,
                i -> new TrainingEnvironment(
                        runners,
                        options,
                        withoutPhysics ? Optional.of(() -> new ClientPhysics(i, this::advance)) : Optional.empty()),
                !withoutPhysics);
        return description(spec, environments.environment(0)).toString().getBytes(StandardCharsets.UTF_8);
    }

    /** Lets the client compute the physics of a cycle while it waits for the response to its request. */
    private ByteBuffer advance(byte[] state) {
        try {
            reply(ADVANCE, state);
            return readMessage();
        } catch (IOException broken) {
            throw new UncheckedIOException(broken);
        }
    }

    private byte[] setPolicy(ByteBuffer request) {
        environments.setPolicy(PolicyText.parse(text(request)));
        return new byte[0];
    }

    private static String text(ByteBuffer request) {
        return StandardCharsets.UTF_8.decode(request).toString();
    }

    private byte[] change(ByteBuffer request) {
        List<String> options = text(request).lines().toList();
        environments.setOptions(new EnvironmentSpec("", options).randomization());
        return new byte[0];
    }

    private byte[] picture(ByteBuffer request) {
        return EnvironmentPicture.of(environment(request).now()).getBytes(StandardCharsets.UTF_8);
    }

    private byte[] view(ByteBuffer request) throws IOException {
        TrainingEnvironment environment = environment(request);
        Optional<EnvironmentRenderer> open = renderers.stream()
                .filter(renderer -> renderer.shows(environment))
                .findFirst();
        EnvironmentRenderer renderer = open.isPresent() ? open.get() : new EnvironmentRenderer(environment, viewer);
        if (open.isEmpty()) {
            renderers.add(renderer);
        }
        return renderer.addresses().getBytes(StandardCharsets.UTF_8);
    }

    private TrainingEnvironment environment(ByteBuffer request) {
        return environments.environment(request.getInt());
    }

    private static JsonObject description(EnvironmentSpec spec, TrainingEnvironment environment) {
        TrainingTask task = environment.task();
        List<String> actions = task.outputs().stream()
                .map(Quantity::name)
                .map(name -> name.substring(name.indexOf('.') + 1))
                .toList();
        JsonObject all = new JsonObject();
        all.addProperty("task", spec.task());
        all.addProperty("reward", spec.reward());
        all.addProperty("longestCycles", environment.longestCycles());
        all.addProperty("cycles", environment.cyclesPerAction());
        all.addProperty("actionLimit", task.actionLimit());
        all.add(
                "rangeDegrees",
                GSON.toJsonTree(task.joints().stream().map(task::rangeDegrees).toList()));
        all.add(
                "motion",
                GSON.toJsonTree(task.motion().map(MotionGuide::numbers).orElse(List.of())));
        all.add("walk", GSON.toJsonTree(task.walk().map(Policy::numbers).orElse(Map.of())));
        all.add("observation", GSON.toJsonTree(environment.quantities()));
        all.add("action", GSON.toJsonTree(actions));
        all.add("output", GSON.toJsonTree(task.outputs()));
        all.add("truth", GSON.toJsonTree(PrivilegedState.NAMES));
        all.add("trueState", GSON.toJsonTree(environment.hasTrueState() ? TrueState.QUANTITIES : List.of()));
        all.add("robots", GSON.toJsonTree(environment.names()));
        return all;
    }
}

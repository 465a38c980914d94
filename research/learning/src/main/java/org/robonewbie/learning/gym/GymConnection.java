package org.robonewbie.learning.gym;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
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
import org.robonewbie.agent.policy.Quantity;

/** Serves one program: makes its environments and lets them act, see docs/gym-protocol.md. */
final class GymConnection {

    private static final int LARGEST_MESSAGE = 64 << 20;
    private static final int MOST_ENVIRONMENTS = 1024;
    private static final byte MAKE = 'M';
    private static final byte ACT = 'A';
    private static final byte CHANGE = 'C';
    private static final byte PICTURE = 'P';
    private static final byte VIEW = 'V';
    private static final byte WELL = 0;
    private static final byte WRONG = 1;

    private final DataInputStream input;
    private final DataOutputStream output;
    private final GymOrder usual;
    private final ClassLoader classes;
    private final GymStage stage;
    private GymCrowd crowd = GymCrowd.NOBODY;
    private final List<GymShow> shows = new ArrayList<>();

    GymConnection(DataInputStream input, DataOutputStream output, GymOrder usual, ClassLoader classes, GymStage stage) {
        this.input = input;
        this.output = output;
        this.usual = usual;
        this.classes = classes;
        this.stage = stage;
    }

    /** Answers requests until the other side leaves. */
    void serve() throws IOException {
        try {
            while (true) {
                answer(readMessage());
            }
        } catch (EOFException left) {
            // The program has ended.
        } finally {
            end();
        }
    }

    private void end() {
        shows.forEach(GymShow::close);
        shows.clear();
        crowd.close();
    }

    private ByteBuffer readMessage() throws IOException {
        int length = Integer.reverseBytes(input.readInt());
        if (length < 1 || length > LARGEST_MESSAGE) {
            throw new IOException("A learning program sent a message of " + length
                    + " bytes. Do both sides have the same version of RoboNewbie?");
        }
        byte[] bytes = new byte[length];
        input.readFully(bytes);
        return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    }

    private void answer(ByteBuffer request) throws IOException {
        try {
            byte kind = request.get();
            switch (kind) {
                case MAKE -> reply(WELL, make(request));
                case ACT -> reply(WELL, crowd.act(request));
                case CHANGE -> reply(WELL, change(request));
                case PICTURE -> reply(WELL, picture(request));
                case VIEW -> reply(WELL, view(request));
                default -> throw new IllegalArgumentException("There is no request of kind " + kind + ".");
            }
        } catch (IllegalArgumentException | java.nio.BufferUnderflowException wrong) {
            reply(WRONG, String.valueOf(wrong.getMessage()).getBytes(StandardCharsets.UTF_8));
        }
    }

    private void reply(byte status, byte[] content) throws IOException {
        ByteBuffer frame = ByteBuffer.allocate(5 + content.length).order(ByteOrder.LITTLE_ENDIAN);
        frame.putInt(1 + content.length).put(status).put(content);
        output.write(frame.array());
        output.flush();
    }

    private byte[] make(ByteBuffer request) {
        int count = request.getInt();
        if (count < 1 || count > MOST_ENVIRONMENTS) {
            throw new IllegalArgumentException(
                    count + " environments were asked for; there can be 1 to " + MOST_ENVIRONMENTS + ".");
        }
        String message = text(request);
        GymOrder order = usual.completing(message);
        GymOptions options = GymOrder.options(message.lines().skip(1));
        Supplier<List<GymEpisode>> episodes = order.episodes(classes);
        end();
        crowd = GymCrowd.of(count, () -> new GymEnvironment(episodes, options));
        return description(order, crowd.environment(0)).toString().getBytes(StandardCharsets.UTF_8);
    }

    private static String text(ByteBuffer request) {
        return StandardCharsets.UTF_8.decode(request).toString();
    }

    private byte[] change(ByteBuffer request) {
        GymOptions options = GymOrder.options(text(request).lines());
        crowd.setOptions(options);
        return new byte[0];
    }

    private byte[] picture(ByteBuffer request) {
        return GymPicture.of(environment(request).now()).toString().getBytes(StandardCharsets.UTF_8);
    }

    private byte[] view(ByteBuffer request) throws IOException {
        GymEnvironment environment = environment(request);
        Optional<GymShow> open =
                shows.stream().filter(show -> show.shows(environment)).findFirst();
        GymShow show = open.isPresent() ? open.get() : GymShow.open(environment, stage);
        if (open.isEmpty()) {
            shows.add(show);
        }
        return show.addresses().getBytes(StandardCharsets.UTF_8);
    }

    private GymEnvironment environment(ByteBuffer request) {
        return crowd.environment(request.getInt());
    }

    private static JsonObject description(GymOrder order, GymEnvironment environment) {
        JsonArray observation = new JsonArray();
        for (ObservedQuantity quantity : environment.quantities()) {
            JsonObject entry = new JsonObject();
            entry.addProperty("name", quantity.name());
            entry.addProperty("unit", quantity.unit());
            entry.addProperty("least", quantity.least());
            entry.addProperty("greatest", quantity.greatest());
            observation.add(entry);
        }
        JsonArray action = new JsonArray();
        environment.task().outputs().stream()
                .map(Quantity::name)
                .map(GymConnection::withoutKind)
                .forEach(action::add);
        JsonObject all = new JsonObject();
        all.addProperty("task", order.task());
        all.addProperty("reward", order.reward());
        all.addProperty("longestCycles", environment.task().longestCycles());
        all.addProperty("rangeDegrees", environment.task().rangeDegrees());
        JsonArray motion = new JsonArray();
        environment.task().motion().map(MotionGuide::numbers).orElse(List.of()).forEach(motion::add);
        all.add("motion", motion);
        all.add("walk", walk(environment.task()));
        all.add("observation", observation);
        all.add("action", action);
        JsonArray truth = new JsonArray();
        GymTruth.NAMES.forEach(truth::add);
        all.add("truth", truth);
        JsonArray robots = new JsonArray();
        environment.names().forEach(robots::add);
        all.add("robots", robots);
        return all;
    }

    private static String withoutKind(String output) {
        return output.substring(output.indexOf('.') + 1);
    }

    private static JsonObject walk(GymTask task) {
        JsonObject walk = new JsonObject();
        task.walk().map(Policy::numbers).orElse(Map.of()).forEach((name, numbers) -> {
            JsonArray row = new JsonArray();
            numbers.forEach(row::add);
            walk.add(name, row);
        });
        return walk;
    }
}

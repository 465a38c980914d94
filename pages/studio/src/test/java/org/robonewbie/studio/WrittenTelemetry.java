package org.robonewbie.studio;

import com.google.gson.Gson;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.protocol.telemetry.BelievedThing;
import org.robonewbie.protocol.telemetry.Drawing;
import org.robonewbie.protocol.telemetry.TelemetryItem;
import org.robonewbie.protocol.telemetry.TelemetryLine;
import org.robonewbie.protocol.telemetry.TelemetryMessage;

/** Telemetry of all kinds as written by Java, with the expected values, for the scripts that read it. */
final class WrittenTelemetry {

    private static final int MESSAGES = 300;
    private static final List<String> TEXTS = List.of(
            "", "ball", "tab\there", "new\nline", "back\\slash", "\\t is no tab", "Zoë ⚽", "carriage\rreturn", "-");

    private final Random random = new Random(11);

    private WrittenTelemetry() {}

    /** Writes lines and the expected value of each as JSON. */
    static void write(Path file) throws IOException {
        WrittenTelemetry telemetry = new WrittenTelemetry();
        List<Map<String, Object>> all = IntStream.range(0, MESSAGES)
                .mapToObj(i -> telemetry.next(i % 6))
                .toList();
        Files.writeString(file, new Gson().toJson(all));
    }

    private Map<String, Object> next(int kind) {
        TelemetryItem item = switch (kind) {
            case 0 -> new TelemetryItem.LogEntry("INFO", text());
            case 1 -> new TelemetryItem.MotionProgress("walk-forward", random.nextInt(30));
            case 2 -> new TelemetryItem.Belief(many(this::thing), self());
            case 3 -> new TelemetryItem.Picture(many(this::drawing));
            case 4 -> new TelemetryItem.DeclaredNumber("gain " + text(), number(), number(), number(), number());
            default -> new TelemetryItem.PlotValue("ball " + text(), number());
        };
        TelemetryMessage message = new TelemetryMessage("Ada " + text(), 1 + random.nextInt(11), number(), item);
        return Map.of(
                "line", TelemetryLine.write(message),
                "team", message.team(),
                "number", message.number(),
                "seconds", message.seconds(),
                "kind", item.getClass().getSimpleName(),
                "item", meaning(item));
    }

    private static Map<String, Object> meaning(TelemetryItem item) {
        if (item instanceof TelemetryItem.LogEntry entry) {
            return Map.of("level", entry.level(), "text", entry.text());
        }
        if (item instanceof TelemetryItem.MotionProgress motion) {
            return Map.of("name", motion.name(), "keyframe", motion.keyframe());
        }
        if (item instanceof TelemetryItem.Belief belief) {
            return Map.of(
                    "self",
                            belief.self().stream()
                                    .map(pose -> List.of(pose.x(), pose.y(), pose.degrees()))
                                    .toList(),
                    "things",
                            belief.things().stream()
                                    .map(WrittenTelemetry::meaning)
                                    .toList());
        }
        if (item instanceof TelemetryItem.Picture picture) {
            return Map.of(
                    "drawings",
                    picture.drawings().stream().map(WrittenTelemetry::meaning).toList());
        }
        if (item instanceof TelemetryItem.DeclaredNumber number) {
            return Map.of(
                    "name", number.name(),
                    "defaultValue", number.defaultValue(),
                    "min", number.min(),
                    "max", number.max(),
                    "value", number.value());
        }
        TelemetryItem.PlotValue plot = (TelemetryItem.PlotValue) item;
        return Map.of("name", plot.name(), "value", plot.value());
    }

    private static Map<String, Object> meaning(BelievedThing thing) {
        return Map.of(
                "name", thing.name(),
                "position", list(thing.position()),
                "ageSeconds", thing.ageSeconds(),
                "visible", thing.visible());
    }

    private static Map<String, Object> meaning(Drawing drawing) {
        if (drawing instanceof Drawing.Line line) {
            return Map.of("shape", "line", "colour", line.colour(), "place", list(line.from()), "to", list(line.to()));
        }
        if (drawing instanceof Drawing.Circle circle) {
            List<Double> centre = list(circle.centre());
            return Map.of("shape", "circle", "colour", circle.colour(), "place", centre, "radius", circle.radius());
        }
        if (drawing instanceof Drawing.Text text) {
            return Map.of("shape", "text", "colour", text.colour(), "place", list(text.place()), "text", text.text());
        }
        Drawing.Point point = (Drawing.Point) drawing;
        return Map.of("shape", "point", "colour", point.colour(), "place", list(point.place()));
    }

    private Optional<Pose2d> self() {
        return random.nextBoolean() ? Optional.of(new Pose2d(number(), number(), number())) : Optional.empty();
    }

    private BelievedThing thing() {
        return new BelievedThing(text(), place(), Math.abs(number()), random.nextBoolean());
    }

    private Drawing drawing() {
        return switch (random.nextInt(4)) {
            case 0 -> new Drawing.Point(place(), "red");
            case 1 -> new Drawing.Line(place(), place(), "#0f0");
            case 2 -> new Drawing.Circle(place(), Math.abs(number()), "blue");
            default -> new Drawing.Text(place(), text(), "white");
        };
    }

    private <T> List<T> many(Supplier<T> make) {
        List<T> made = new ArrayList<>();
        for (int i = random.nextInt(4); i > 0; i--) {
            made.add(make.get());
        }
        return made;
    }

    private String text() {
        return TEXTS.get(random.nextInt(TEXTS.size()));
    }

    private Vector3 place() {
        return new Vector3(number(), number(), number());
    }

    /** A number with few digits, which survives formatting. */
    private double number() {
        return Math.round(random.nextDouble() * 20_000 - 10_000) / 1000.0;
    }

    private static List<Double> list(Vector3 place) {
        return List.of(place.x(), place.y(), place.z());
    }
}

package org.robonewbie.protocol.telemetry;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.protocol.telemetry.TelemetryItem.Belief;
import org.robonewbie.protocol.telemetry.TelemetryItem.DeclaredNumber;
import org.robonewbie.protocol.telemetry.TelemetryItem.LogEntry;
import org.robonewbie.protocol.telemetry.TelemetryItem.MotionProgress;
import org.robonewbie.protocol.telemetry.TelemetryItem.Picture;
import org.robonewbie.protocol.telemetry.TelemetryItem.PlotValue;

/**
 * The text format of telemetry, with one message per line: kind of item, time in seconds, team and shirt number, followed by
 * the fields of the item, all separated by tabs. Tabs, line breaks and backslashes in a field are escaped as {@code \t}, {@code
 * \n} and {@code \\}.
 *
 * <pre>
 * log    12.34  Blue  3  INFO  ball at 1.20 m
 * motion 12.36  Blue  3  walk-forward  4
 * belief 12.36  Blue  3  -0.5 0.4 -40.0  ball 1.2 0.1 -0.45 0.0 1
 * draw   12.36  Blue  3  circle red 1.2 0.1 -0.45 0.1
 * plot   12.36  Blue  3  ball distance  1.2
 * number 12.36  Blue  3  gain  0.5  0.0  1.0  0.75
 * </pre>
 */
public final class TelemetryLine {

    private static final String NO_POSE = "-";

    private TelemetryLine() {}

    /**
     * Formats a message.
     *
     * @param message the message
     * @return one line without its line terminator
     */
    public static String write(TelemetryMessage message) {
        FieldWriter fields = new FieldWriter(kind(message.item()));
        fields.number(message.seconds()).text(message.team()).text(Integer.toString(message.number()));
        TelemetryItem item = message.item();
        if (item instanceof LogEntry entry) {
            fields.text(entry.level()).text(entry.text());
        } else if (item instanceof MotionProgress motion) {
            fields.text(motion.name()).text(Integer.toString(motion.keyframe()));
        } else if (item instanceof Belief belief) {
            write(belief, fields);
        } else if (item instanceof Picture picture) {
            picture.drawings().forEach(drawing -> write(drawing, fields));
        } else if (item instanceof PlotValue plot) {
            fields.text(plot.name()).number(plot.value());
        } else if (item instanceof DeclaredNumber number) {
            write(number, fields);
        }
        return fields.toString();
    }

    /**
     * Parses a message.
     *
     * @param line one line without its line terminator
     * @return the message; empty if the line is not telemetry
     */
    public static Optional<TelemetryMessage> read(String line) {
        try {
            FieldReader fields = new FieldReader(line);
            String kind = fields.text();
            double seconds = fields.number();
            String team = fields.text();
            int number = Integer.parseInt(fields.text());
            return Optional.of(new TelemetryMessage(team, number, seconds, item(kind, fields)));
        } catch (IllegalArgumentException notTelemetry) {
            return Optional.empty();
        }
    }

    private static String kind(TelemetryItem item) {
        if (item instanceof LogEntry) {
            return "log";
        }
        if (item instanceof MotionProgress) {
            return "motion";
        }
        if (item instanceof Belief) {
            return "belief";
        }
        if (item instanceof DeclaredNumber) {
            return "number";
        }
        return item instanceof Picture ? "draw" : "plot";
    }

    private static TelemetryItem item(String kind, FieldReader fields) {
        return switch (kind) {
            case "log" -> new LogEntry(fields.text(), fields.text());
            case "motion" -> new MotionProgress(fields.text(), Integer.parseInt(fields.text()));
            case "belief" -> belief(fields);
            case "draw" -> picture(fields);
            case "plot" -> new PlotValue(fields.text(), fields.number());
            case "number" ->
                new DeclaredNumber(fields.text(), fields.number(), fields.number(), fields.number(), fields.number());
            default -> throw new IllegalArgumentException("unknown kind of telemetry: " + kind);
        };
    }

    /** Writes a tunable parameter without rounding its values. */
    private static void write(DeclaredNumber number, FieldWriter fields) {
        fields.text(number.name());
        for (double value : new double[] {number.defaultValue(), number.min(), number.max(), number.value()}) {
            fields.text(Double.toString(value));
        }
    }

    private static void write(Belief belief, FieldWriter fields) {
        if (belief.self().isPresent()) {
            Pose2d self = belief.self().get();
            fields.number(self.x()).number(self.y()).number(self.degrees());
        } else {
            fields.text(NO_POSE);
        }
        for (BelievedThing thing : belief.things()) {
            fields.text(thing.name()).vector(thing.position()).number(thing.ageSeconds());
            fields.text(thing.visible() ? "1" : "0");
        }
    }

    private static Belief belief(FieldReader fields) {
        String first = fields.text();
        Optional<Pose2d> self = first.equals(NO_POSE)
                ? Optional.empty()
                : Optional.of(new Pose2d(Double.parseDouble(first), fields.number(), fields.number()));
        List<BelievedThing> things = new ArrayList<>();
        while (fields.hasMore()) {
            things.add(new BelievedThing(
                    fields.text(),
                    fields.vector(),
                    fields.number(),
                    fields.text().equals("1")));
        }
        return new Belief(things, self);
    }

    private static void write(Drawing drawing, FieldWriter fields) {
        if (drawing instanceof Drawing.Point point) {
            fields.text("point").text(point.colour()).vector(point.place());
        } else if (drawing instanceof Drawing.Line line) {
            fields.text("line").text(line.colour()).vector(line.from()).vector(line.to());
        } else if (drawing instanceof Drawing.Circle circle) {
            fields.text("circle").text(circle.colour()).vector(circle.centre()).number(circle.radius());
        } else if (drawing instanceof Drawing.Text text) {
            fields.text("text").text(text.colour()).vector(text.place()).text(text.text());
        }
    }

    private static Picture picture(FieldReader fields) {
        List<Drawing> drawings = new ArrayList<>();
        while (fields.hasMore()) {
            String shape = fields.text();
            String colour = fields.text();
            Vector3 place = fields.vector();
            drawings.add(
                    switch (shape) {
                        case "point" -> new Drawing.Point(place, colour);
                        case "line" -> new Drawing.Line(place, fields.vector(), colour);
                        case "circle" -> new Drawing.Circle(place, fields.number(), colour);
                        case "text" -> new Drawing.Text(place, fields.text(), colour);
                        default -> throw new IllegalArgumentException("unknown shape: " + shape);
                    });
        }
        return new Picture(drawings);
    }
}

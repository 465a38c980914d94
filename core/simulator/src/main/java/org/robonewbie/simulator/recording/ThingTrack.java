package org.robonewbie.simulator.recording;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.simulator.landscape.Thing;

/**
 * Encoding of the objects on the pitch: all objects when their number or kind changes, otherwise only those that have
 * moved. Poses are not delta-encoded, because objects are at rest most of the time.
 */
final class ThingTrack {

    private List<Thing> last = List.of();

    /** Writes the changes since the previous call. */
    void write(List<Thing> things, RecordSink sink) {
        if (things.equals(last)) {
            return;
        }
        if (isSameButForPoses(things)) {
            writeMoved(things, sink);
        } else {
            writeAll(things, sink.newPayload());
            sink.put(RecordingFormat.THINGS);
        }
        last = List.copyOf(things);
    }

    private boolean isSameButForPoses(List<Thing> things) {
        boolean same = things.size() == last.size();
        for (int i = 0; same && i < things.size(); i++) {
            same = things.get(i).at(last.get(i).pose()).equals(last.get(i));
        }
        return same;
    }

    private static void writeAll(List<Thing> things, ByteSink payload) {
        payload.putUnsigned(things.size());
        for (Thing thing : things) {
            payload.putText(thing.name());
            payload.putUnsigned(PortableMath.round(thing.size().x() * RecordingFormat.STEPS_PER_METRE));
            payload.putUnsigned(PortableMath.round(thing.size().y() * RecordingFormat.STEPS_PER_METRE));
            payload.putUnsigned(PortableMath.round(thing.size().z() * RecordingFormat.STEPS_PER_METRE));
            payload.putUnsigned(PortableMath.round(thing.massKg() * RecordingFormat.STEPS_PER_KILOGRAM));
            putPose(thing, payload);
        }
    }

    private void writeMoved(List<Thing> things, RecordSink sink) {
        for (int i = 0; i < things.size(); i++) {
            if (!things.get(i).equals(last.get(i))) {
                ByteSink payload = sink.newPayload();
                payload.putUnsigned(i);
                putPose(things.get(i), payload);
                sink.put(RecordingFormat.MOVED_THING);
            }
        }
    }

    private static void putPose(Thing thing, ByteSink payload) {
        new DeltaTrack(RecordingFormat.NUMBERS_PER_POSE).putPose(0, thing.pose(), payload);
    }

    /** Reads a record of kind {@link RecordingFormat#THINGS}. */
    static List<Thing> readAll(RecordCursor source) {
        List<Thing> things = new ArrayList<>();
        for (long count = source.getUnsigned(); count > 0; count--) {
            String name = source.getText();
            Vector3 size = new Vector3(
                    source.getUnsigned() / RecordingFormat.STEPS_PER_METRE,
                    source.getUnsigned() / RecordingFormat.STEPS_PER_METRE,
                    source.getUnsigned() / RecordingFormat.STEPS_PER_METRE);
            double massKg = source.getUnsigned() / RecordingFormat.STEPS_PER_KILOGRAM;
            things.add(new Thing(name, size, massKg, DeltaTrack.readPose(source)));
        }
        return things;
    }

    /**
     * Reads a record of kind {@link RecordingFormat#MOVED_THING} and returns all objects, including the one with the new
     * pose.
     */
    static List<Thing> readMoved(List<Thing> before, RecordCursor source) {
        int index = source.getIndex(before.size());
        List<Thing> now = new ArrayList<>(before);
        now.set(index, before.get(index).at(DeltaTrack.readPose(source)));
        return List.copyOf(now);
    }
}

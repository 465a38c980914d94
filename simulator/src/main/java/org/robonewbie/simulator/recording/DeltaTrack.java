package org.robonewbie.simulator.recording;

import java.io.IOException;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.physics.Pose;

/** Numbers of which each cycle only the changes are kept. */
final class DeltaTrack {

    private final long[] last;

    DeltaTrack(int count) {
        last = new long[count];
    }

    void put(int index, double value, double stepsPerUnit, ByteSink sink) {
        long steps = Math.round(value * stepsPerUnit);
        sink.putSigned(steps - last[index]);
        last[index] = steps;
    }

    /** Writes seven numbers of a snapshot, position and quaternion, from an index on. */
    void putPose(int index, float[] pose, int start, ByteSink sink) {
        for (int i = 0; i < RecordingFormat.NUMBERS_PER_POSE; i++) {
            double steps = i < 3 ? RecordingFormat.STEPS_PER_METRE : RecordingFormat.STEPS_PER_TURN;
            put(index + i, pose[start + i], steps, sink);
        }
    }

    /** Writes seven numbers from an index on. */
    void putPose(int index, Pose pose, ByteSink sink) {
        Vector3 position = pose.position();
        put(index, position.x(), RecordingFormat.STEPS_PER_METRE, sink);
        put(index + 1, position.y(), RecordingFormat.STEPS_PER_METRE, sink);
        put(index + 2, position.z(), RecordingFormat.STEPS_PER_METRE, sink);
        double[] quaternion = pose.rotation().toQuaternion();
        for (int i = 0; i < quaternion.length; i++) {
            put(index + 3 + i, quaternion[i], RecordingFormat.STEPS_PER_TURN, sink);
        }
    }

    double get(int index, double stepsPerUnit, ByteSource source) throws IOException {
        last[index] += source.getSigned();
        return last[index] / stepsPerUnit;
    }
}

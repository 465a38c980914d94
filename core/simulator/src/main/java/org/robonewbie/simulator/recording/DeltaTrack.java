package org.robonewbie.simulator.recording;

import org.jspecify.annotations.Nullable;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.math.PortableMath;

/** Delta encoding of a fixed number of fixed-point values. */
final class DeltaTrack {

    private final long[] last;

    DeltaTrack(int count) {
        last = new long[count];
    }

    /** Returns the given track, or a new one if it is null or its size differs. */
    static DeltaTrack fitting(@Nullable DeltaTrack known, int count) {
        return known != null && known.last.length == count ? known : new DeltaTrack(count);
    }

    void put(int index, double value, double stepsPerUnit, ByteSink sink) {
        long steps = PortableMath.round(value * stepsPerUnit);
        sink.putSigned(steps - last[index]);
        last[index] = steps;
    }

    /** Writes the position and quaternion of a pose as the seven values starting at the given index. */
    void putPose(int index, Pose pose, ByteSink sink) {
        Vector3 position = pose.position();
        put(index, position.x(), RecordingFormat.STEPS_PER_METRE, sink);
        put(index + 1, position.y(), RecordingFormat.STEPS_PER_METRE, sink);
        put(index + 2, position.z(), RecordingFormat.STEPS_PER_METRE, sink);
        Rotation rotation = pose.rotation();
        put(index + 3, rotation.w(), RecordingFormat.STEPS_PER_TURN, sink);
        put(index + 4, rotation.x(), RecordingFormat.STEPS_PER_TURN, sink);
        put(index + 5, rotation.y(), RecordingFormat.STEPS_PER_TURN, sink);
        put(index + 6, rotation.z(), RecordingFormat.STEPS_PER_TURN, sink);
    }

    double get(int index, double stepsPerUnit, RecordCursor source) {
        last[index] += source.getSigned();
        return last[index] / stepsPerUnit;
    }

    /** Reads a pose from the first seven values and normalises its quaternion. */
    Pose getPose(RecordCursor source) {
        double[] numbers = new double[RecordingFormat.NUMBERS_PER_POSE];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = get(i, i < 3 ? RecordingFormat.STEPS_PER_METRE : RecordingFormat.STEPS_PER_TURN, source);
        }
        double length = Math.sqrt(
                numbers[3] * numbers[3] + numbers[4] * numbers[4] + numbers[5] * numbers[5] + numbers[6] * numbers[6]);
        double scale = length == 0 ? 0 : 1 / length;
        return new Pose(
                new Vector3(numbers[0], numbers[1], numbers[2]),
                length == 0
                        ? Rotation.NONE
                        : new Rotation(numbers[3] * scale, numbers[4] * scale, numbers[5] * scale, numbers[6] * scale));
    }

    /** Reads a pose that is not delta-encoded. */
    static Pose readPose(RecordCursor source) {
        return new DeltaTrack(RecordingFormat.NUMBERS_PER_POSE).getPose(source);
    }
}

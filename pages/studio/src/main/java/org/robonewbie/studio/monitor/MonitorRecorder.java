package org.robonewbie.studio.monitor;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.protocol.monitor.MonitoredWorld;
import org.robonewbie.simulator.PitchDetails;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.recording.RecordingTarget;
import org.robonewbie.simulator.recording.RecordingWriter;
import org.robonewbie.simulator.soccer.MatchEvent;

/** Records what a monitor port sends. Cycles between two messages are interpolated. */
final class MonitorRecorder implements AutoCloseable {

    private static final int MAX_INTERPOLATED_CYCLES = 15;

    private final RecordingWriter recording;
    private final List<String> events = new ArrayList<>();
    private Optional<WorldSnapshot> last = Optional.empty();

    private MonitorRecorder(RecordingWriter recording) {
        this.recording = recording;
    }

    /** Starts a recording of a world whose first full message has been read. */
    static MonitorRecorder open(RecordingTarget target, MonitoredWorld world) {
        return new MonitorRecorder(RecordingWriter.open(target, header(world)));
    }

    /** Adds an event to the next snapshot. */
    void happened(MatchEvent event) {
        events.add(event.text());
    }

    /** Writes a snapshot, unless it belongs to the cycle of the last one. */
    void write(WorldSnapshot now) {
        if (last.isPresent() && now.cycle() == last.get().cycle()) {
            return;
        }
        last.ifPresent(before -> {
            long gap = now.cycle() - before.cycle();
            for (long i = 1; i < gap && gap <= MAX_INTERPOLATED_CYCLES; i++) {
                recording.write(Blend.of(before, now, (double) i / gap), List.of());
            }
        });
        recording.write(now, events);
        events.clear();
        last = Optional.of(now);
    }

    @Override
    public void close() {
        recording.close();
    }

    private static List<String> header(MonitoredWorld world) {
        SoccerField field = MonitorSnapshots.field(world);
        List<String> header = new ArrayList<>(List.of(
                "FieldLength=" + field.length(),
                "FieldWidth=" + field.width(),
                "GoalWidth=" + field.goalWidth(),
                "GoalDepth=" + field.goalDepth(),
                "GoalHeight=" + field.goalHeight(),
                "PenaltyLength=" + field.penaltyLength(),
                "PenaltyWidth=" + field.penaltyWidth(),
                "FreeKickDistance=" + field.centreCircleRadius()));
        PitchDetails details = MonitorSnapshots.details(world);
        if (!details.equals(PitchDetails.SIMSPARK)) {
            header.add("BallRadius=" + details.ballRadius());
            header.add("GoalAreaLength=" + details.goalAreaLength());
            header.add("GoalAreaWidth=" + details.goalAreaWidth());
            header.add("PenaltySpotDistance=" + details.penaltySpotDistance());
        }
        return header;
    }
}

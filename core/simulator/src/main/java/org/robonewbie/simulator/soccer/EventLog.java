package org.robonewbie.simulator.soccer;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.protocol.monitor.FoulType;

/** Events of a match that have not been recorded yet. */
final class EventLog implements Restorable {

    private final List<MatchEvent> events = new ArrayList<>();
    private final List<MatchEvent> readOnly = Collections.unmodifiableList(events);

    void add(MatchEvent event) {
        events.add(event);
    }

    void clear() {
        events.clear();
    }

    List<MatchEvent> events() {
        return readOnly;
    }

    @Override
    public void save(StateWriter out) {
        out.putAll(events, event -> save(event, out));
    }

    @Override
    public void restore(StateReader in) {
        events.clear();
        events.addAll(in.getAll(() -> event(in)));
    }

    private static void save(MatchEvent event, StateWriter out) {
        if (event instanceof MatchEvent.PlayModeChanged change) {
            out.putInt(0);
            out.putEnum(change.playMode());
        } else if (event instanceof MatchEvent.GoalScored goal) {
            out.putInt(1);
            out.putEnum(goal.side());
            out.putText(goal.team());
        } else if (event instanceof MatchEvent.FoulCalled foul) {
            out.putInt(2);
            out.putEnum(foul.foul());
            out.putEnum(foul.side());
            out.putInt(foul.number());
        }
    }

    private static MatchEvent event(StateReader in) {
        return switch (in.getIndex(3)) {
            case 0 -> new MatchEvent.PlayModeChanged(in.getEnum(PlayMode.values()));
            case 1 -> new MatchEvent.GoalScored(in.getEnum(TeamSide.values()), in.getText());
            default ->
                new MatchEvent.FoulCalled(in.getEnum(FoulType.values()), in.getEnum(TeamSide.values()), in.getInt());
        };
    }
}

package org.robonewbie.studio.monitor;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.protocol.monitor.Foul;
import org.robonewbie.protocol.monitor.MonitoredGame;
import org.robonewbie.simulator.soccer.MatchEvent;

/** Derives match events from consecutive messages of a monitor port. */
final class MonitorEvents {

    private MonitorEvents() {}

    static List<MatchEvent> between(MonitoredGame before, MonitoredGame now) {
        List<MatchEvent> events = new ArrayList<>();
        if (before.equals(MonitoredGame.UNKNOWN)) {
            return events;
        }
        if (now.scoreLeft() > before.scoreLeft()) {
            events.add(new MatchEvent.GoalScored(TeamSide.LEFT, now.teamLeft().orElse("left")));
        }
        if (now.scoreRight() > before.scoreRight()) {
            events.add(new MatchEvent.GoalScored(TeamSide.RIGHT, now.teamRight().orElse("right")));
        }
        now.playMode()
                .filter(mode -> !before.playMode().equals(now.playMode()))
                .ifPresent(mode -> events.add(new MatchEvent.PlayModeChanged(mode)));
        return events;
    }

    static MatchEvent of(Foul foul) {
        return new MatchEvent.FoulCalled(
                foul.type(), foul.player().side(), foul.player().number());
    }
}

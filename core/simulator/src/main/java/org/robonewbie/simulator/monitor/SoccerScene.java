package org.robonewbie.simulator.monitor;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.robonewbie.protocol.monitor.TransformNode;
import org.robonewbie.simulator.soccer.SoccerParameters;

/**
 * The scene that monitors draw: pitch, ball, other objects, and robots in the order in which they connected.
 */
final class SoccerScene {

    private final PitchScene pitch;
    private final Map<Integer, RobotFigure> figures = new LinkedHashMap<>();
    private final ThingFigures things = new ThingFigures();
    private List<TransformNode> nodes;

    SoccerScene(SoccerParameters parameters) {
        pitch = new PitchScene(parameters);
        nodes = List.copyOf(pitch.nodes());
    }

    List<TransformNode> nodes() {
        return nodes;
    }

    /** Updates the nodes; returns whether anything but poses has changed, which requires a full message. */
    boolean update(MonitorSnapshot snapshot) {
        pitch.ball().moveTo(snapshot.ballTransform(), 0);
        List<Integer> ids =
                snapshot.robots().stream().map(MonitoredRobotState::id).toList();
        boolean changed = figures.keySet().retainAll(ids);
        changed |= things.update(snapshot.things());
        for (MonitoredRobotState robot : snapshot.robots()) {
            changed |= show(robot);
        }
        if (changed) {
            nodes = allNodes();
        }
        return changed;
    }

    private boolean show(MonitoredRobotState robot) {
        RobotFigure known = figures.get(robot.id());
        if (known != null && known.type() == robot.type()) {
            return known.update(robot);
        }
        RobotFigure figure = new RobotFigure(robot.type());
        figure.update(robot);
        figures.put(robot.id(), figure);
        return true;
    }

    private List<TransformNode> allNodes() {
        List<TransformNode> all = new ArrayList<>(pitch.nodes());
        all.addAll(things.nodes());
        figures.values().forEach(figure -> all.add(figure.root()));
        return List.copyOf(all);
    }
}

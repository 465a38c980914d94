package org.robonewbie.simulator.sensing;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;

/**
 * Line segments of a pitch in SimSpark's order: centre line, goal lines, side lines, penalty areas, and the centre circle as ten
 * chords; 21 in all.
 */
final class FieldLines {

    private static final int CHORDS = 10;

    private final List<Segment> segments = new ArrayList<>();

    private FieldLines() {}

    static List<Segment> of(SoccerField field) {
        FieldLines lines = new FieldLines();
        double x = field.length() / 2;
        double y = field.width() / 2;
        lines.add(0, -y, 0, y);
        lines.add(x, -y, x, y);
        lines.add(-x, -y, -x, y);
        lines.add(x, y, -x, y);
        lines.add(x, -y, -x, -y);
        lines.addPenaltyArea(field, 1);
        lines.addPenaltyArea(field, -1);
        lines.addCentreCircle(field.centreCircleRadius());
        return List.copyOf(lines.segments);
    }

    private void addPenaltyArea(SoccerField field, int side) {
        double goalLine = side * field.length() / 2;
        double front = goalLine - side * field.penaltyLength();
        double y = (field.penaltyWidth() + field.goalWidth()) / 2;
        add(front, y, front, -y);
        add(front, y, goalLine, y);
        add(front, -y, goalLine, -y);
    }

    private void addCentreCircle(double radius) {
        for (int i = 0; i < CHORDS; i++) {
            double from = 2 * Math.PI * i / CHORDS;
            double to = 2 * Math.PI * (i + 1) / CHORDS;
            add(
                    radius * PortableMath.cos(from),
                    radius * PortableMath.sin(from),
                    radius * PortableMath.cos(to),
                    radius * PortableMath.sin(to));
        }
    }

    private void add(double startX, double startY, double endX, double endY) {
        segments.add(new Segment(new Vector3(startX, startY, 0), new Vector3(endX, endY, 0)));
    }
}

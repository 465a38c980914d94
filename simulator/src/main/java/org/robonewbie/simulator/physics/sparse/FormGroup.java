package org.robonewbie.simulator.physics.sparse;

import java.util.ArrayList;
import java.util.List;

/** Moving forms that never touch each other, with the box around all of them. */
final class FormGroup {

    private final List<Form> forms = new ArrayList<>();
    private final double[] low = new double[3];
    private final double[] high = new double[3];

    void add(Form form) {
        forms.add(form);
    }

    List<Form> forms() {
        return forms;
    }

    void measure() {
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = Double.POSITIVE_INFINITY;
            high[axis] = Double.NEGATIVE_INFINITY;
        }
        for (int i = 0; i < forms.size(); i++) {
            Form form = forms.get(i);
            form.measure();
            for (int axis = 0; axis < 3; axis++) {
                low[axis] = Math.min(low[axis], form.low[axis]);
                high[axis] = Math.max(high[axis], form.high[axis]);
            }
        }
    }

    boolean isNear(FormGroup other) {
        return overlap(low, high, other.low, other.high);
    }

    boolean isNear(Form form) {
        return overlap(low, high, form.low, form.high);
    }

    private static boolean overlap(double[] low, double[] high, double[] otherLow, double[] otherHigh) {
        for (int axis = 0; axis < 3; axis++) {
            if (!(low[axis] <= otherHigh[axis] && otherLow[axis] <= high[axis])) {
                return false;
            }
        }
        return true;
    }
}

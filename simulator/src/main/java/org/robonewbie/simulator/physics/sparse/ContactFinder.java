package org.robonewbie.simulator.physics.sparse;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.robonewbie.simulator.physics.ode.OdeCollisions;

/**
 * Looks where forms touch: the ground by itself, all else with ODE's collision, and that only if the boxes around two
 * groups overlap.
 */
final class ContactFinder {

    private static final int MOST_POINTS = 4;

    private final OdeCollisions collisions = new OdeCollisions();
    private final List<FormGroup> movers = new ArrayList<>();
    private final List<Form> fixtures = new ArrayList<>();
    private final List<Form> misplaced = new ArrayList<>();
    private final MoveClock clock = new MoveClock();
    private final double[] points = new double[MOST_POINTS * OdeCollisions.NUMBERS_PER_POINT];
    private @Nullable SparseCollider ground;

    OdeCollisions collisions() {
        return collisions;
    }

    MoveClock clock() {
        return clock;
    }

    void setGround(SparseCollider collider) {
        ground = collider;
    }

    void add(FormGroup group) {
        movers.add(group);
    }

    void remove(FormGroup group) {
        movers.remove(group);
    }

    void addFixture(Form form) {
        form.measure();
        form.placeTwin();
        fixtures.add(form);
    }

    void removeFixture(Form form) {
        fixtures.remove(form);
    }

    void find(ContactList contacts) {
        for (int i = 0; i < movers.size(); i++) {
            movers.get(i).measure();
        }
        if (isAnythingNear()) {
            placeTwins();
            collisions.find(contacts);
        }
        if (ground != null) {
            findOnGround(ground, contacts);
        }
        clock.beginPeriod();
    }

    private boolean isAnythingNear() {
        for (int i = 0; i < movers.size(); i++) {
            FormGroup mover = movers.get(i);
            for (int j = 0; j < i; j++) {
                if (mover.isNear(movers.get(j))) {
                    return true;
                }
            }
            for (int j = 0; j < fixtures.size(); j++) {
                if (mover.isNear(fixtures.get(j))) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Reports all moves to ODE since the last time, in their order, since ODE's order of pairs comes from it. */
    private void placeTwins() {
        for (FormGroup mover : movers) {
            for (Form form : mover.forms()) {
                if (form.isMisplaced()) {
                    misplaced.add(form);
                }
            }
        }
        misplaced.sort(Comparator.comparingInt(Form::turn));
        misplaced.forEach(Form::placeTwin);
        misplaced.clear();
    }

    private void findOnGround(SparseCollider plane, ContactList contacts) {
        for (int i = 0; i < movers.size(); i++) {
            List<Form> forms = movers.get(i).forms();
            for (int j = 0; j < forms.size(); j++) {
                Form form = forms.get(j);
                int count = form.low[2] <= 0 ? form.touchGround(points) : 0;
                if (count > 0) {
                    contacts.touch(form.collider, plane, points, count);
                }
            }
        }
    }
}

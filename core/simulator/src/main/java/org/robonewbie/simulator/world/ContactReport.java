package org.robonewbie.simulator.world;

import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.simulator.physics.Contact;

/** Evaluates the contacts of a step for the referee and the foot sensors. */
final class ContactReport {

    private final List<RobotPart> ballTouches = new ArrayList<>();
    private final List<RobotContact> robotContacts = new ArrayList<>();
    private final List<RobotPart> readOnlyTouches = Collections.unmodifiableList(ballTouches);
    private final List<RobotContact> readOnlyContacts = Collections.unmodifiableList(robotContacts);
    private final Set<TeamSide> goalsWithBall = EnumSet.noneOf(TeamSide.class);

    void read(List<Contact> contacts) {
        ballTouches.clear();
        robotContacts.clear();
        goalsWithBall.clear();
        contacts.forEach(this::read);
    }

    void forget(Robot robot) {
        ballTouches.removeIf(touch -> touch.robot() == robot);
        robotContacts.removeIf(
                contact -> contact.first().robot() == robot || contact.second().robot() == robot);
    }

    List<RobotPart> ballTouches() {
        return readOnlyTouches;
    }

    List<RobotContact> robotContacts() {
        return readOnlyContacts;
    }

    boolean isBallInGoal(TeamSide side) {
        return goalsWithBall.contains(side);
    }

    private void read(Contact contact) {
        Object first = contact.first().owner();
        Object second = contact.second().owner();
        if (first instanceof Ball) {
            addBallTouch(second);
        } else if (second instanceof Ball) {
            addBallTouch(first);
        }
        if (first instanceof RobotPart part) {
            part.robot().addContact(part.link(), contact);
            if (second instanceof RobotPart other) {
                robotContacts.add(new RobotContact(part, other, contact.position()));
            }
        }
    }

    private void addBallTouch(Object other) {
        if (other instanceof RobotPart part) {
            if (ballTouches.stream().noneMatch(touch -> touch.robot() == part.robot())) {
                ballTouches.add(part);
            }
        } else if (other instanceof Pitch.GoalMouth goal) {
            goalsWithBall.add(goal.side());
        }
    }

    void save(StateWriter out, List<Robot> robots) {
        out.putAll(ballTouches, part -> save(part, out, robots));
        out.putAll(robotContacts, contact -> {
            save(contact.first(), out, robots);
            save(contact.second(), out, robots);
            out.putVector(contact.position());
        });
        out.putAll(goalsWithBall, out::putEnum);
    }

    void restore(StateReader in, List<Robot> robots) {
        ballTouches.clear();
        robotContacts.clear();
        goalsWithBall.clear();
        ballTouches.addAll(in.getAll(() -> part(in, robots)));
        robotContacts.addAll(in.getAll(() -> new RobotContact(part(in, robots), part(in, robots), in.getVector())));
        goalsWithBall.addAll(in.getAll(() -> in.getEnum(TeamSide.values())));
    }

    private static void save(RobotPart part, StateWriter out, List<Robot> robots) {
        out.putInt(robots.indexOf(part.robot()));
        out.putInt(part.link());
    }

    private static RobotPart part(StateReader in, List<Robot> robots) {
        Robot robot = robots.get(in.getIndex(robots.size()));
        return new RobotPart(robot, in.getIndex(robot.model().bodies().size()));
    }
}

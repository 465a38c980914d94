package org.robonewbie.app.course;

import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.SensorReadings;
import org.robonewbie.trial.guest.AbsentProgramException;
import org.robonewbie.trial.guest.GuestDoor;

/** A robot of a student's process, which is called when it is known who it is. */
final class CalledRobot implements Controller {

    private final Student student;
    private final GuestDoor door;
    private Optional<Controller> guest = Optional.empty();

    CalledRobot(Student student, GuestDoor door) {
        this.student = student;
        this.door = door;
    }

    @Override
    public void introduce(String team, int number, TeamSide side) {
        student.call(new RobotsOnCall.Call(door.port(), team, number, side));
        guest = Optional.of(door.await(() -> student.reason(door.port()).isEmpty()));
    }

    @Override
    public List<EffectorCommand> respond(SensorReadings readings) {
        try {
            return guest.orElseThrow().respond(readings);
        } catch (AbsentProgramException gone) {
            student.exitCode();
            throw gone;
        }
    }

    @Override
    public void close() {
        guest.ifPresent(Controller::close);
    }
}

package org.robonewbie.workshop.fidelity;

import java.util.List;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.simulator.world.Ball;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.simulator.world.SoccerWorld;

/** World without a server, rules or messages. */
final class WorldStage implements ReplayStage {

    private final SoccerWorld world;
    private final Robot robot;

    WorldStage(RobotType type, JoiningWay way) {
        world = new SoccerWorld(SoccerField.LEAGUE);
        robot = world.addRobot(type);
        join(way);
    }

    @Override
    public Robot robot() {
        return robot;
    }

    @Override
    public void placeBall(Vector3 position) {
        world.ball().place(position);
    }

    @Override
    public Ball ball() {
        return world.ball();
    }

    @Override
    public Measurements step(List<EffectorCommand> commands) {
        Measurements before = Measurements.of(robot);
        commands.forEach(this::apply);
        world.step();
        return before;
    }

    @Override
    public void close() {
        // There are no external resources.
    }

    /** Lets the robot join as on a server, where it falls for several cycles before it has a team. */
    private void join(JoiningWay way) {
        for (int i = 0; i < way.cyclesToInit(); i++) {
            world.step();
        }
        robot.moveUpright(way.place(), way.yawDegrees());
        world.step();
    }

    private void apply(EffectorCommand command) {
        if (command instanceof EffectorCommand.SetHingeSpeed speed) {
            robot.nao()
                    .hingeIndex(speed.effectorName())
                    .ifPresent(hinge -> robot.setMotorSpeed(hinge, speed.radiansPerSecond()));
        } else if (command instanceof EffectorCommand.Beam beam) {
            robot.beam(
                    new Vector3(beam.pose().x(), beam.pose().y(), RecordedCommands.BEAM_HEIGHT),
                    beam.pose().degrees() - 90);
        }
    }
}

package org.robonewbie.workshop.fidelity;

import java.io.IOException;
import java.util.List;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.simulator.world.Ball;
import org.robonewbie.simulator.world.Robot;

/** A fresh world with one robot on which a recorded run is played again. */
interface ReplayStage extends AutoCloseable {

    /**
     * Prepares a stage.
     *
     * @param route how the commands reach the robot
     * @param type the robot's build
     * @param way how the robot joins its team; a server has such places only as it gives to its players
     * @return the stage; its robot has joined a team in the last cycle
     * @throws IOException if a server cannot be started
     */
    static ReplayStage open(AgentRoute route, RobotType type, JoiningWay way) throws IOException {
        return route == AgentRoute.NONE ? new WorldStage(type, way) : ServerStage.open(route, type, way);
    }

    /** Places a ball, at rest and in play. */
    void placeBall(Vector3 position);

    /** The ball. */
    Ball ball();

    /** The robot, to place it where the run begins and to read its true pose. */
    Robot robot();

    /**
     * Sends the robot some commands and runs 20 ms.
     *
     * @param commands what the recorded client sent
     * @return the robot's perception before these 20 ms
     * @throws IOException if the connection is broken
     */
    Measurements step(List<EffectorCommand> commands) throws IOException;

    @Override
    void close();
}

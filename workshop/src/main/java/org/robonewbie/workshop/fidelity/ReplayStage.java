package org.robonewbie.workshop.fidelity;

import java.io.IOException;
import java.util.List;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.simulator.world.Ball;
import org.robonewbie.simulator.world.Robot;

/** Fresh world with one robot that replays a recorded run. */
interface ReplayStage extends AutoCloseable {

    /**
     * Creates a stage.
     *
     * @param route transport for the commands
     * @param type the robot type
     * @param way start sequence of the robot; a server supports only its own start positions
     * @return a stage whose robot has joined a team in the last cycle
     * @throws IOException if a server cannot be started
     */
    static ReplayStage open(AgentRoute route, RobotType type, JoiningWay way) throws IOException {
        return route == AgentRoute.NONE ? new WorldStage(type, way) : ServerStage.open(route, type, way);
    }

    /** Places the ball at rest and starts the game. */
    void placeBall(Vector3 position);

    Ball ball();

    /** {@return the robot, for placing it initially and reading its true pose} */
    Robot robot();

    /**
     * Sends commands to the robot and simulates 20 ms.
     *
     * @param commands commands of the recorded client
     * @return the sensor values before this step
     * @throws IOException if the connection is broken
     */
    Measurements step(List<EffectorCommand> commands) throws IOException;

    @Override
    void close();
}
